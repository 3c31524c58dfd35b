// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "pipeline/document/artifact.hpp"

namespace ashimpact {

/// Identity of the run that starts from a case: a hash of the program's version and revision, of the case and
/// of the bytes of its inputs. The same inputs give the same bytes of all artifacts, so runs of one identity
/// may be mixed; others may not.
[[nodiscard]] std::string run_identity(const Json& case_result, const Json& inputs);

/// Writes the identity of its run and a hash of its result, which reveals later edits, into the provenance of
/// an artifact.
void seal(Json& document, const std::string& run);

/// Identity of the run that an artifact is of. @throws InputError if it has none
[[nodiscard]] std::string run_of(const Json& document);

/// Whether the result of an artifact is not what ashimpact wrote. Layout and comments do not count.
[[nodiscard]] bool is_edited(const Json& document);

/// Refuses artifacts of different runs. @throws InputError naming one that does not belong to the first
void require_one_run(const std::vector<Artifact>& artifacts);

/// Checks every quantity of an edited result: it is possible, and lies inside of its interval.
/// @throws InputError with the JSON pointer of the first that does not
void require_possible_result(const Json& document);

/// Artifacts that were computed from another version of one that they read, in words: "3-analytic.json was
/// computed from another 2-contact.json".
[[nodiscard]] std::vector<std::string> outdated(const std::vector<Artifact>& artifacts);

}  // namespace ashimpact
