// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/command.hpp"

#include <ostream>

#include "pipeline/app/deposit/deposit.hpp"
#include "pipeline/app/deposit/sizes_choice.hpp"
#include "pipeline/present/text/deposition_text.hpp"

namespace ashimpact {

namespace {

void run_deposit_command(const CommandOptions& options, std::ostream& out) {
    const Deposition deposition = write_deposition(options, table_options(options));
    out << deposition_text(deposition.result) << "Written:";
    for (const std::filesystem::path& file : deposition.files) out << ' ' << file.string();
    out << '\n';
}

}  // namespace

void add_deposit(const CommandLine& line) {
    Command command = line.add(
        "deposit", "What stays on a tube in a flow of ash: mass by size and around the tube",
        "ashimpact deposit results --tube-diameter \"38 mm\" --gas-velocity \"12 m/s\" --gas-temperature "
        "\"900 C\" "
        "--sizes \"rosin-rammler: 20 um, 1.2\" --ash-load \"10 g/m3\" -o tube\n"
        "  ashimpact deposit --law jkr --density \"2300 kg/m3\" --contact-modulus \"90 GPa\" "
        "--work-of-adhesion "
        "\"0.3 J/m2\" --damping-law tsuji --damping 0.5 --tube-diameter \"38 mm\" --gas-velocity \"12 m/s\" "
        "--gas-temperature \"900 C\" --sizes \"20 um\" -o tube",
        run_deposit_command);
    command.add("run", "RUN_DIR", "folder of a finished run; else give the options of an impact");
    command.add("--tube-diameter", "Q", "outside, \"38 mm\"")->required();
    command.add("--gas-velocity", "Q", "far upstream, \"12 m/s\"")->required();
    command.add("--gas-temperature", "Q", "\"900 C\"")->required();
    command.add("--gas-viscosity", "Q", "default: that of air at the temperature");
    command.add("--sizes", "SPEC", sizes_forms)->required();
    command.add("--ash-load", "Q",
                "mass of ash in the gas, \"10 g/m3\" at its temperature, \"35 g/Nm3\" at 0 C; without it "
                "shares only");
    command.add(
        "--assumption", "NAME",
        "of a run: what v_c follows from where sizes were not measured, tsuji; default: the first that the "
        "impacts admit of contact-radius, tsuji, hunt-crossley, brach-dunn-damping, power-of-size, constant");
    command.add_table_options();
    command.add_contact_options(false);
    command.add_damping_option();
    command.add("-o,--output", "DIR", "folder to write")->required();
}

}  // namespace ashimpact
