// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "materials/modulus.hpp"
#include "materials/xrd/xrd.hpp"
#include "pipeline/app/commands/materials/modulus.hpp"

namespace ashimpact {

/// The built-in phases behind those of the options. @throws InputError naming the option
[[nodiscard]] PhaseCatalogue catalogue_of(const ModulusCommandOptions& options);

/// A sample of the file with what the options say of its amorphous part. @throws InputError naming the option
[[nodiscard]] XrdSample completed(const XrdSample& sample, const ModulusCommandOptions& options);

/// The composition; where nothing says what is amorphous, the error names the options that do.
[[nodiscard]] Composition composed(const XrdSample& sample, const PhaseCatalogue& catalogue);

/// The porosity of the options, if any, for phases of this density [kg/m3]; `note` tells where it follows
/// from the particle density. @throws InputError naming the option
[[nodiscard]] std::optional<Porosity> porosity_of(const ModulusCommandOptions& options, double true_density,
                                                  std::string& note);

/// The measured density of the particle, pores included [kg/m3]. @throws InputError naming the option
[[nodiscard]] std::optional<double> measured_density(const ModulusCommandOptions& options);

}  // namespace ashimpact
