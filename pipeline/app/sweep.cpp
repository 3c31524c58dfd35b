// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/command.hpp"

namespace ashimpact {

void add_sweep(const CommandLine& line, const SweepRunner& runner) {
    auto [command, options] = line.add<SweepOptions>(
        "sweep", "Many impacts: grids, Monte Carlo, sensitivity; also under mpirun",
        "ashimpact sweep spec.json -o sweep.json\n"
        "  mpirun -n 4 ashimpact sweep spec.json -o sweep.json\n"
        "A spec, such as (`ashimpact schema sweep` and docs/sweep.md say all):\n"
        "  {\n"
        "    \"impact\": {\"laws\": [\"dmt\", \"jkr\"], \"density\": \"2600 kg/m3\",\n"
        "               \"contact_modulus\": \"90 GPa\", \"damping\": \"0.0141 kg/s\",\n"
        "               \"work_of_adhesion\": \"0.3 J/m2\"},\n"
        "    \"variables\": {\n"
        "      \"velocity\": {\"distribution\": \"uniform\",\n"
        "                   \"from\": \"0.5 m/s\", \"to\": \"5 m/s\"},\n"
        "      \"radius\": {\"distribution\": \"log-normal\", \"median\": \"44 um\",\n"
        "                 \"geometric_standard_deviation\": 1.5}},\n"
        "    \"sampling\": {\"method\": \"quasi-random\", \"samples\": 65536, \"seed\": 1},\n"
        "    \"sensitivity\": [\"restitution\"]\n"
        "  }\n"
        "The result is the same for any number of processes and threads. A sweep that was "
        "stopped goes on from its\ncheckpoint, beside the result, when the same command runs "
        "again.",
        runner);
    add_text(*command, "spec", options->spec, "SPEC.json", "JSON file that says what to compute")->required();
    add_text(*command, "-o,--output", options->output, "FILE",
             "JSON file for the result; a full table goes beside it (.h5)")
        ->required();
    command->add_option("--threads", options->threads, "of each process; 0: its share of the cores")
        ->capture_default_str()
        ->check(whole_number(0, 1024));
    command->add_option("--checkpoint", options->checkpoint_interval, "seconds between checkpoints")
        ->capture_default_str()
        ->check(number_within(0, 1e6))
        ->type_name("SECONDS");
    command->add_flag("--restart", options->restart, "begin anew though there is a checkpoint");
    command->add_flag("--no-report", options->no_report,
                      "leave out the report, which stands beside the result (.html)");
    command->add_flag("--progress", options->progress, "show progress though standard error is no terminal");
}

}  // namespace ashimpact
