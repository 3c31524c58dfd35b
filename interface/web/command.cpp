// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as a function, for the package of npm: what it writes goes to the standard streams of the
// module.
#include "pipeline/app/command.hpp"

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "core/json/document.hpp"
#include "core/text/error.hpp"

/// Runs one command. @param words a JSON array, the program's name first @returns the exit status
extern "C" int ashimpact_command(const char* words) {
    using namespace ashimpact;
    std::vector<std::string> texts;
    for (const Json& word : parse_json(words)) texts.push_back(word.get<std::string>());
    std::vector<const char*> arguments;
    for (const std::string& text : texts) arguments.push_back(text.c_str());
    const int status = run_program(
        static_cast<int>(arguments.size()), arguments.data(),
        [](const CommandOptions&, std::ostream&) {
            throw InputError("sweep needs MPI and HDF5, which this package does not have",
                             "the program for Linux");
        },
        [](const CommandOptions& options, std::ostream& out) {
            if (options["code"] == "table")
                throw InputError("export table needs HDF5, which this package does not have",
                                 "the program for Linux, or another code");
            run_export_command(options, {}, out);
        });
    std::cout.flush();
    std::fflush(nullptr);
    return status;
}
