// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/report/data/run_data.hpp"

namespace ashimpact::report {

std::string display_name(std::string_view law) {
    const bool spelled = law.find_first_of("aeiou") == std::string_view::npos;  // an abbreviation
    std::string name;
    bool capital = true;
    for (const char c : law) {
        const bool letter = c >= 'a' && c <= 'z';
        name += letter && (capital || spelled) ? static_cast<char>(c - 'a' + 'A') : c;
        capital = !letter;
    }
    return name;
}

std::optional<double> LawData::extrapolated() const {
    if (velocity == nullptr || !velocity->extrapolated) return std::nullopt;
    return velocity->extrapolated->velocity.value;
}

const ModelCurve& LawData::curve() const {
    static const ModelCurve none;
    return drawn != nullptr ? drawn->impacts : none;
}

RunData::RunData(Run run, std::string label) : label_(std::move(label)), run_(std::move(run)) {
    for (std::size_t i = 0; i < run_.data.samples.size(); ++i) {
        SampleData sample{.sample = &run_.data.samples[i],
                          .modulus = &run_.modulus.samples.at(i),
                          .contact = &run_.contact.samples.at(i),
                          .analytic = &run_.analytic.samples.at(i),
                          .velocity = &run_.critical_velocity.samples.at(i),
                          .comparison = &run_.comparison.samples.at(i)};
        for (const LawChoice& choice : run_.data.laws)
            sample.laws.push_back({.choice = choice,
                                   .name = display_name(choice.law.name()),
                                   .measured = run_.restitution.samples.at(i).of(choice.law),
                                   .damping = run_.damping.samples.at(i).laws.find(choice.law),
                                   .fit = run_.fit.samples.at(i).laws.find(choice.law),
                                   .velocity = sample.velocity->laws.find(choice.law),
                                   .compared = sample.comparison->laws.find(choice.law),
                                   .histories = run_.histories.samples.at(i).laws.find(choice.law),
                                   .drawn = run_.histories.samples.at(i).curves.find(choice.law)});
        samples_.push_back(std::move(sample));
    }
}

std::string RunData::damping_unit() const {
    return std::string(unit_of(run_.data.damping_law));
}

}  // namespace ashimpact::report
