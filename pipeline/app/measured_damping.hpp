// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

#include "pipeline/app/options/contact_options.hpp"

namespace ashimpact {

/// Options of `ashimpact damping`.
struct DampingOptions {
    ContactOptions contact;  ///< its damping is what is asked for, so not given
    std::string velocity;
    std::string restitution;
    std::string impacts;     ///< table of measured impacts, instead of one velocity and restitution
    std::string sheet;       ///< of a spreadsheet; empty: the only one with such a table
    std::string frame_rate;  ///< of the camera they were seen with [frames/s]
    std::string pixel_size;
    int frames = 0;            ///< positions to a velocity; 0: not given
    std::string size_scatter;  ///< of single diameters, relative
    int order = 2;             ///< of the extrapolated polynomial
    bool robust = false;       ///< bisquare weights in the extrapolation
    int bin = 0;               ///< rebounds to a bin; 0: none
    bool json = false;
};

/// `ashimpact damping --impacts FILE`: damping and critical velocity from a series of measured impacts
/// velocity under one law; intervals are those of the impacts, the contact is taken as exactly known.
void run_measured_damping_command(const DampingOptions& options, std::ostream& out);

}  // namespace ashimpact
