// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/present/export/run_subject.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "core/quantities/quantity.hpp"
#include "core/text/error.hpp"
#include "core/text/text.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/artifact.hpp"
#include "pipeline/document/edits.hpp"
#include "pipeline/document/results_json.hpp"
#include "pipeline/present/text/result_text.hpp"
#include "pipeline/run/comparison/temperature.hpp"
#include "pipeline/run/stage.hpp"
#include "solver/inference/calibration/published_damping.hpp"
#include "solver/motion/damping_inversion.hpp"

namespace ashimpact {

namespace {

constexpr int curve_nodes = 24;          // of a fit eta(e)
constexpr std::size_t binned_nodes = 8;  // of impacts without a fit along the velocity
constexpr double clear_restitution = 0.05;
constexpr double clear_deviations = 3;  // of the noise, and of the scatter of particles

/// A sample's name as text: nothing in it may end a line or look like code to a reader of Markdown.
std::string as_text(const std::string& name) {
    std::string text = in_quotes(name);
    std::ranges::replace(text, '`', '\'');
    return text;
}

/// Numbers of the chosen samples in the case.
std::vector<std::size_t> chosen_samples(const Case& data, const RunChoice& choice) {
    std::vector<std::string> names;
    for (const Sample& sample : data.samples) names.push_back(in_quotes(sample.name));
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; choice.samples.empty() && i < data.samples.size(); ++i) chosen.push_back(i);
    for (const std::string& name : choice.samples) {
        const auto found = std::ranges::find(data.samples, name, &Sample::name);
        if (found == data.samples.end())
            throw InputError("no sample is called " + in_quotes(name), joined(names)).at("--sample");
        const auto number = static_cast<std::size_t>(found - data.samples.begin());
        if (std::ranges::find(chosen, number) == chosen.end()) chosen.push_back(number);
    }
    return chosen;
}

/// The law that the run reports for these samples; none if it reports none, or several.
std::optional<Law> reported_law(const Run& run, const std::vector<std::size_t>& samples) {
    std::optional<Law> law;
    for (const std::size_t i : samples) {
        if (i >= run.comparison.samples.size()) return std::nullopt;
        const auto& reported = run.comparison.samples[i].reported;
        if (!reported || !reported->law || (law && *law != *reported->law)) return std::nullopt;
        law = reported->law;
    }
    return law;
}

LawChoice law_of(const Run& run, const RunChoice& choice, const std::vector<std::size_t>& samples) {
    const auto& laws = run.data.laws;
    std::vector<std::string> names;
    for (const LawChoice& each : laws) names.emplace_back(each.law.name());
    if (!choice.law.empty()) {
        const auto found =
            std::ranges::find(laws, choice.law, [](const LawChoice& each) { return each.law.name(); });
        if (found != laws.end()) return *found;
        throw InputError("the run has no law " + in_quotes(choice.law), joined(names)).at("--law");
    }
    if (laws.size() == 1) return laws.front();
    const auto law = reported_law(run, samples);
    const auto found = law ? std::ranges::find(laws, *law, &LawChoice::law) : laws.end();
    if (found != laws.end()) return *found;
    throw InputError("the run reports no one law for these samples", joined(names)).at("--law");
}

/// What a stage has of a law. @throws InputError with @p problem and @p allowed where there is none
template <class Laws>
const auto& found_in(const Laws& laws, const LawChoice& law, const std::string& problem,
                     const char* allowed) {
    if (const auto* found = laws.find(law.law)) return *found;
    throw InputError(problem, allowed).at("--law");
}

/// All that a run has of one sample by one law.
struct RunSample {
    const std::string& name;
    const LawChoice& law;
    DampingLaw damping_law;
    const SampleContact& contact;
    const RestitutionSeries* measured;  ///< null: none
    const DampingSeries& series;
    const LawFit& fit;
    const LawCriticalVelocity& headline;

    [[nodiscard]] Impact impact(double coefficient, double velocity) const {
        return {law.law, law.detachment, {damping_law, coefficient}, contact.pair, velocity};
    }
    [[nodiscard]] CriticalVelocity critical(double coefficient) const {
        return critical_velocity({.law = law.law,
                                  .detachment = law.detachment,
                                  .damping = {damping_law, coefficient},
                                  .contact = contact.pair});
    }
};

RunSample run_sample(const Run& run, const LawChoice& law, std::size_t i) {
    const std::string& name = run.data.samples[i].name;
    return {.name = name,
            .law = law,
            .damping_law = run.data.damping_law,
            .contact = run.contact.samples[i],
            .measured = run.restitution.samples[i].of(law.law),
            .series = found_in(run.damping.samples[i].laws, law, "5-damping.json has no impacts by this law",
                               "a law with impacts"),
            .fit = found_in(
                run.fit.samples[i].laws, law,
                fmt::format("there is no fit of the damping by {} for {}", law.law.name(), in_quotes(name)),
                "a law with a fit in 6-fit.json"),
            .headline = found_in(
                run.critical_velocity.samples[i].laws, law,
                fmt::format("7-critical-velocity.json has no critical velocity by {}", law.law.name()),
                "a law with one")};
}

/// The damping at which the run's critical velocity is one.
struct CriticalDamping {
    double coefficient;              ///< [unit of the damping law]
    std::optional<double> velocity;  ///< v_c; none where the verdict of the run is not finite [m/s]
    bool of_headline = false;        ///< solved for the headline; else the fit's own eta(e = 0)
};

/// The headline may be read from data or edited: then the smallest damping that captures at it.
CriticalDamping critical_damping(const RunSample& sample) {
    constexpr double same = 1e-9;  // relative; the headline is written with as many digits
    const double coefficient = sample.fit.critical_damping;
    const CriticalVelocity of_fit = sample.critical(coefficient);
    if (!sample.headline.velocity) return {coefficient, of_fit.value};
    const double velocity = sample.headline.velocity->value;
    if (of_fit.value && std::abs(velocity / *of_fit.value - 1) <= same) return {coefficient, of_fit.value};
    const DampingInversion inversion = damping_from_restitution({.law = sample.law.law,
                                                                 .detachment = sample.law.detachment,
                                                                 .damping_law = sample.damping_law,
                                                                 .contact = sample.contact.pair,
                                                                 .velocity = velocity,
                                                                 .restitution = 0});
    return {inversion.damping.coefficient, velocity, true};
}

/// Refuses a v_c at which clear rebounds were measured: slower ones than it and than any particle within the
/// scatter of the sample could have.
void require_agreement(const RunSample& sample, const CriticalDamping& critical) {
    if (sample.measured == nullptr || !critical.velocity) return;
    const double scatter = sample.fit.estimate ? sample.fit.estimate->particle_scatter : 0;
    const auto slowest_possible =
        sample.critical(critical.coefficient * std::exp(-clear_deviations * scatter)).value;
    double bound = std::min(*critical.velocity, slowest_possible.value_or(0));
    if (const auto& headline = sample.headline.velocity; headline && headline->interval)
        bound = std::min(bound, headline->interval->lower.value_or(0));
    const auto& points = sample.measured->impacts.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Measurement& point = points[i];
        const bool outlier = std::ranges::find(sample.series.outliers, i + 1) != sample.series.outliers.end();
        const double incident = point.noise ? point.noise->incident : 0;
        const double rebound = point.noise ? point.noise->rebound : 0;
        const bool clear = !point.captured() && !outlier && point.restitution() >= clear_restitution &&
                           point.rebound > clear_deviations * rebound;
        if (!clear || point.velocity + clear_deviations * incident >= bound) continue;
        throw InputError(
            fmt::format(
                "{}: the run's critical velocity by {} is {}, but a {} impact of {} rebounds with e = {}",
                in_quotes(sample.name), sample.law.law.name(), readable(*critical.velocity, "m/s"),
                sample.measured->origin == Origin::measured ? "measured" : "reconstructed",
                readable(point.velocity, "m/s"), readable_number(point.restitution(), 2)),
            "a law or a sample whose critical velocity the impacts do not contradict");
    }
}

/// A point of the damping along the velocity.
struct DampingAt {
    double velocity;     ///< [m/s]
    double coefficient;  ///< [unit of the damping law]
};

/// eta(v_in) where an impact with the fit's eta(e) gives e back, over the rising branch.
std::vector<DampingAt> along_fit(const RunSample& sample, double critical) {
    double greatest = 0;
    for (std::size_t i = 0; i < sample.series.velocity.size(); ++i)
        if (!sample.series.rising || sample.series.velocity[i] <= sample.series.rising->to)
            greatest = std::max(greatest, sample.series.restitution[i]);
    std::vector<DampingAt> points;
    for (int i = 1; i <= curve_nodes; ++i) {
        const double e = greatest * i / curve_nodes;
        const double eta = sample.fit.along_rising_branch()(e);
        if (!(e > 0 && eta >= 0)) continue;
        try {
            points.push_back({velocity_of_restitution(sample.impact(eta, critical), e), eta});
        } catch (const InputError&) {  // no velocity has that restitution
            continue;
        }
    }
    return points;
}

/// Means of neighbouring impacts.
std::vector<DampingAt> along_impacts(const DampingSeries& series) {
    std::vector<DampingAt> impacts;
    for (std::size_t i = 0; i < series.velocity.size(); ++i)
        impacts.push_back({series.velocity[i], series.damping[i]});
    std::ranges::sort(impacts, {}, &DampingAt::velocity);
    const std::size_t count = std::min(binned_nodes, impacts.size());
    std::vector<DampingAt> means;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t from = k * impacts.size() / count;
        const std::size_t to = (k + 1) * impacts.size() / count;
        DampingAt mean{0, 0};
        for (std::size_t i = from; i < to; ++i) {
            mean.velocity += impacts[i].velocity / static_cast<double>(to - from);
            mean.coefficient += impacts[i].coefficient / static_cast<double>(to - from);
        }
        means.push_back(mean);
    }
    return means;
}

/// The damping along the velocity and where it is from.
struct FollowedDamping {
    std::vector<DampingAt> points;
    std::string_view source;
};

FollowedDamping followed(const RunSample& sample, double critical) {
    const auto& estimate = sample.fit.estimate;
    if (estimate && estimate->curve) {
        FollowedDamping damping{{}, "the curve of damping over velocity of 6-fit.json"};
        for (std::size_t i = 1; i < estimate->curve->velocity.size(); ++i)
            damping.points.push_back({estimate->curve->velocity[i], estimate->curve->damping[i]});
        return damping;
    }
    if (sample.damping_law == DampingLaw::constant)
        return {along_fit(sample, critical), "the fit eta(e) of 6-fit.json along the velocity"};
    return {along_impacts(sample.series), "means of neighbouring impacts of 5-damping.json"};
}

/// From the critical damping on; a point at which spheres would be captured is left out.
DampingCurve curve_of(const RunSample& sample, const CriticalDamping& critical,
                      const std::vector<DampingAt>& points) {
    // Of v: v_c is hardly known better, and a fit may fold back by less just above it.
    constexpr double least_step = 0.02;
    DampingCurve curve{{{0, critical.coefficient}}};
    double before = *critical.velocity;
    for (const DampingAt& point : points) {
        if (!(point.velocity > before) || !(point.coefficient >= 0)) continue;
        const bool first = curve.nodes.size() == 1;
        if (first && point.velocity < (1 + least_step) * before) continue;
        if (point.coefficient >= critical.coefficient) {
            const CriticalVelocity here = sample.critical(point.coefficient);
            if (here.verdict == CaptureVerdict::always_captured || here.value.value_or(0) >= point.velocity)
                continue;
        }
        curve.nodes.push_back({place_above(point.velocity, *critical.velocity), point.coefficient});
        before = point.velocity;
    }
    return curve;
}

/// The sample as a known size. @param subject gets the lines on its numbers
AshSize size_with_damping(const RunSample& sample, ExportSubject& subject) {
    const CriticalDamping critical = critical_damping(sample);
    require_agreement(sample, critical);
    AshSize size{.diameter = 2 * sample.contact.radius.value,
                 .contact = sample.contact.pair,
                 .density = sample.contact.density.value(),
                 .damping = {{{0, critical.coefficient}}}};
    const std::string smallest = critical.of_headline ? "the smallest that captures at the critical velocity "
                                                        "of 7-critical-velocity.json"
                                                      : "the critical damping eta(e = 0) of 6-fit.json";
    std::string damping = smallest + ", at every velocity: there is no finite critical velocity";
    if (critical.velocity) {
        const FollowedDamping along = followed(sample, *critical.velocity);
        size.damping = curve_of(sample, critical, along.points);
        damping =
            fmt::format("up to v_c {}; above it {}, {} nodes up to {}, and that of the last node beyond",
                        smallest, along.source, size.damping.nodes.size(),
                        readable(velocity_at_place(size.damping.nodes.back().t, *critical.velocity), "m/s"));
    }
    subject.dampings.push_back(fmt::format("damping of {}: {}", as_text(sample.name), damping));
    subject.origins.insert(
        subject.origins.end(),
        {fmt::format("sample {} of a run of ashimpact, diameter {}", as_text(sample.name),
                     readable(size.diameter, "m")),
         fmt::format("E* = {}, contact modulus of {} together (2-contact.json)",
                     readable(sample.contact.contact_modulus.quantity),
                     sample.contact.partner ? "both spheres" : "particle and wall"),
         fmt::format("w = {}, work of adhesion of the pair of surfaces (2-contact.json)",
                     readable(sample.contact.work_of_adhesion.quantity)),
         fmt::format("density {} (2-contact.json)", readable(sample.contact.density.quantity))});
    return size;
}

Laboratory laboratory_of(const RunSample& sample, double diameter) {
    Laboratory laboratory{.sample = as_text(sample.name), .diameter = diameter};
    if (sample.measured == nullptr) return laboratory;
    laboratory.reconstructed = sample.measured->origin != Origin::measured;
    for (const Measurement& point : sample.measured->impacts.sorted())
        laboratory.impacts.push_back({point.velocity, point.captured() ? 0 : point.restitution()});
    return laboratory;
}

/// Adds what the temperature of the run leaves of its velocities.
void add_temperature_doubts(const Run& run, Law law, std::size_t i, std::vector<std::string>& doubts) {
    if (i >= run.comparison.samples.size() || !run.comparison.samples[i].temperature) return;
    const SampleComparison& sample = run.comparison.samples[i];
    for (const auto& [of_law, finding] : temperature_notes(*sample.temperature))
        if (finding.severity == Severity::doubt && of_law.value_or(law) == law)
            doubts.push_back(as_text(sample.name) + ": " + finding.text);
}

/// A line for each artifact of a run that was edited, also where a later one states it.
std::vector<std::string> edits_of(const Run& run) {
    std::set<std::string> lines;
    for (const StageRecord& record : run.records) {
        if (record.edited) lines.insert(fmt::format("{} {}", record.file, edited_words));
        for (const Note& note : record.notes)
            if (note.code == "edited" || note.code == "rests-on-edit") lines.insert(note.text);
    }
    return {lines.begin(), lines.end()};
}

void require_two_diameters(const std::vector<AshSize>& sizes) {
    const auto twice = std::ranges::adjacent_find(sizes, {}, &AshSize::diameter);
    if (twice != sizes.end())
        throw InputError(fmt::format("two samples have the diameter {}", readable(twice->diameter, "m")),
                         "samples of different sizes, each by a --sample")
            .at("--sample");
}

}  // namespace

ExportSubject subject_of_run(const RunChoice& choice) {
    std::vector<std::string_view> files{case_artifact,    contact_artifact, restitution_artifact,
                                        damping_artifact, fit_artifact,     critical_velocity_artifact};
    std::error_code ignored;
    const bool reports =
        std::filesystem::is_regular_file(std::filesystem::path(choice.folder) / comparison_artifact, ignored);
    // With a law, the comparison adds what the temperature leaves of v_c, and nothing else.
    if (reports &&
        (choice.law.empty() ||
         loaded_artifact(choice.folder, case_artifact).document->at("result").contains("temperature")))
        files.push_back(comparison_artifact);
    const Run run = read_run(load_artifacts(choice.folder, files));
    const auto chosen = chosen_samples(run.data, choice);
    const LawChoice law = law_of(run, choice, chosen);

    ExportSubject subject{.law = law.law,
                          .detachment = law.detachment,
                          .damping_law = run.data.damping_law,
                          .sizes = {},
                          .from_diameter = 0,
                          .to_diameter = 0};
    subject.edits = edits_of(run);
    for (const std::size_t i : chosen) {
        const RunSample sample = run_sample(run, law, i);
        subject.sizes.push_back(size_with_damping(sample, subject));
        subject.laboratory.push_back(laboratory_of(sample, subject.sizes.back().diameter));
        add_temperature_doubts(run, law.law, i, subject.doubts);
        if (const auto& check = sample.headline.check; check && check->contradicts())
            subject.doubts.push_back(fmt::format("{}: v_c of the run is {} for the one measured there",
                                                 as_text(sample.name), verdict_words(check)));
        if (const auto& partner = sample.contact.partner)
            subject.partner = {partner->radius.value, partner->mass.value};
    }
    if (run.data.friction && !subject.partner) subject.friction = run.data.friction->value();
    std::ranges::sort(subject.sizes, {}, &AshSize::diameter);
    std::ranges::sort(subject.laboratory, {}, &Laboratory::diameter);
    require_two_diameters(subject.sizes);
    subject.from_diameter = subject.sizes.front().diameter;
    subject.to_diameter = subject.sizes.back().diameter;
    if (subject.sizes.size() > 1)
        subject.origins.emplace_back(
            "between two samples E*, w and density are linear in ln d, and so is ln(damping) at equal "
            "v/v_c");
    return subject;
}

}  // namespace ashimpact
