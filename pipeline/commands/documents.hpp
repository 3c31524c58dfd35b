#pragma once

#include <iosfwd>
#include <string>

namespace ashimpact {

/// `ashimpact inspect`: an artifact as tables, with its provenance.
void run_inspect_command(const std::string& file, std::ostream& out);

/// `ashimpact init`: writes a commented case to start from. @throws InputError if there is one already
void run_init_command(const std::string& folder, std::ostream& out);

/// `ashimpact schema`: the JSON Schema of that name; the names where it is empty.
void run_schema_command(const std::string& name, std::ostream& out);

}  // namespace ashimpact
