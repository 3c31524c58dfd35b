// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

namespace ashimpact {

struct InspectOptions {
    std::string file;
    bool all = false;  ///< every row and every part
};

/// `ashimpact inspect`: an artifact as tables; with -v its inputs, options and citations too.
void run_inspect_command(const InspectOptions& options, std::ostream& out);

/// `ashimpact init`: writes a commented case to start from. @throws InputError if there is one already
void run_init_command(const std::string& folder, std::ostream& out);

/// `ashimpact schema`: the JSON Schema of that name; the names where it is empty.
void run_schema_command(const std::string& name, std::ostream& out);

}  // namespace ashimpact
