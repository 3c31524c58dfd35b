// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/commands/materials/modulus_options.hpp"

#include "core/checks.hpp"
#include "core/text.hpp"
#include "pipeline/app/commands/contact_options.hpp"
#include "pipeline/case/case_reader.hpp"
#include "pipeline/document/files/file.hpp"
#include "pipeline/run/modulus.hpp"

namespace ashimpact {

namespace {

/// "0.42", "42 %", "42(2) %" or "42 +- 2 %", as in a case.
Quantity read_fraction(const char* option, const std::string& text) {
    return at_place(option, [&] {
        Quantity fraction = quantity_of_text(text, Dimension::fraction);
        require_fraction("the fraction", fraction.value);
        return fraction;
    });
}

Amorphous read_amorphous(const std::string& text, FractionBasis basis) {
    if (text == "none") return AmorphousNone{};
    if (text == "remainder") return AmorphousRemainder{};
    const Quantity fraction = [&] {
        try {
            return read_fraction("--amorphous-fraction", text);
        } catch (const InputError& error) {
            throw InputError(error.problem(),
                             "a fraction of the whole (0.42, \"42 %\", \"42 +- 2 %\"), none, remainder")
                .at(error.place());
        }
    }();
    if (fraction.value == 0) return AmorphousNone{};
    return AmorphousFraction{fraction.value, fraction.standard_uncertainty, basis};
}

void refuse_contradictions(const ModulusCommandOptions& options) {
    const int ways = (options.amorphous_fraction.empty() ? 0 : 1) +
                     (options.crystalline_total.empty() ? 0 : 1) +
                     (options.internal_standard.empty() ? 0 : 1);
    if (ways > 1)
        throw InputError("the amorphous part is given in " + std::to_string(ways) + " ways", "one of them")
            .at("--amorphous-fraction, --crystalline-total, --internal-standard");
    if (options.internal_standard.empty() != options.added_fraction.empty())
        throw InputError("one is given without the other",
                         "the phase of the standard, and its weight over that of the mixture")
            .at("--internal-standard, --added-fraction");
}

}  // namespace

PhaseCatalogue catalogue_of(const ModulusCommandOptions& options) {
    PhaseCatalogue catalogue = built_in_phases();
    if (!options.phase_set.empty())
        catalogue = at_place("--phase-set", [&] { return catalogue.preferring(options.phase_set); });
    if (options.phases.empty()) return catalogue;
    return at_place(FileName{options.phases}, [&] {
        const Json document = parse_json(read_file(options.phases));
        const View root(document);
        return catalogue.overridden_by(read_user_phases(document.is_array() ? root : root.at("phases")));
    });
}

XrdSample completed(const XrdSample& sample, const ModulusCommandOptions& options) {
    refuse_contradictions(options);
    XrdSample result = sample;
    Analysis& analysis = result.analysis;
    if (!options.amorphous_fraction.empty())
        analysis.amorphous = read_amorphous(options.amorphous_fraction, analysis.basis);
    if (!options.crystalline_total.empty()) {
        const Quantity total = read_fraction("--crystalline-total", options.crystalline_total);
        analysis.amorphous = CrystallineTotal{total.value, total.standard_uncertainty};
    }
    if (options.internal_standard.empty()) return result;
    const Quantity added = read_fraction("--added-fraction", options.added_fraction);
    return at_place("--internal-standard", [&] {
        return with_internal_standard(sample, options.internal_standard, added.value,
                                      added.standard_uncertainty);
    });
}

Composition composed(const XrdSample& sample, const PhaseCatalogue& catalogue) {
    return compose(sample.analysis, catalogue,
                   "--amorphous-fraction X (of the whole; none; remainder: what is missing to 100 %), "
                   "--crystalline-total X, or --internal-standard PHASE with --added-fraction X");
}

std::optional<Porosity> porosity_of(const ModulusCommandOptions& options, double true_density,
                                    std::string& note) {
    if (options.porosity_law.empty()) {
        if (!options.porosity.empty() || !options.porosity_coefficient.empty())
            throw InputError("is missing", "the law by which pores soften, see docs/materials.md")
                .at("--porosity-law");
        return std::nullopt;
    }
    Porosity porosity{
        .law = at_place("--porosity-law", [&] { return named<PorosityLaw>(options.porosity_law); })};
    if (!options.porosity_coefficient.empty())
        porosity.coefficient =
            read_option("--porosity-coefficient", options.porosity_coefficient, Dimension::fraction);
    if (!options.porosity.empty()) {
        const Quantity value = read_fraction("--porosity", options.porosity);
        porosity.value = value.value;
        porosity.standard_uncertainty = value.standard_uncertainty;
    } else if (const auto measured = measured_density(options)) {
        const auto found = at_place("--particle-density", [&] {
            return porosity_from_density(porosity, make_quantity(*measured, Dimension::density),
                                         true_density);
        });
        porosity = found.porosity;
        note = found.note;
    } else {
        throw InputError("neither is given", "the porosity, or the density from which it follows")
            .at("--porosity, --particle-density");
    }
    at_place("--porosity", [&] { require_valid(porosity); });
    return porosity;
}

std::optional<double> measured_density(const ModulusCommandOptions& options) {
    if (options.particle_density.empty()) return std::nullopt;
    const double density = read_option("--particle-density", options.particle_density, Dimension::density);
    at_place("--particle-density", [&] { require_positive("density", density, Dimension::density); });
    return density;
}

}  // namespace ashimpact
