// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/quantities/names.hpp"
#include "core/text/error.hpp"

namespace ashimpact {

/// How much a finding matters to a reader of the results.
enum class Severity {
    background,  ///< changes no decision: how something was read, what was assumed
    remark,      ///< worth knowing
    doubt,       ///< a result is missing or may be wrong
};

template <>
struct Names<Severity> {
    static constexpr std::string_view kind = "severity";
    static constexpr std::array<std::string_view, 3> all{"background", "remark", "doubt"};
};

/// A remark of a computation on its result. The computation sets code, severity and text; its caller adds the
/// sample and the law. Code that reads findings compares the code, never the text.
struct Finding {
    std::string_view code;  ///< a literal such as "outliers"; never changes
    Severity severity;
    std::string text;  ///< one sentence, without sample and law
};

/// The texts of findings, in their order.
[[nodiscard]] inline std::vector<std::string> texts_of(const std::vector<Finding>& findings) {
    std::vector<std::string> texts;
    for (const Finding& finding : findings) texts.push_back(finding.text);
    return texts;
}

/// Returns the result of @p compute. If the data do not allow it or it does not converge, adds the finding
/// "no <what>: <reason>" with @p code and @p severity, and returns none.
template <class Compute>
[[nodiscard]] auto attempt(const std::string& what, std::string_view code, Severity severity,
                           std::vector<Finding>& findings, Compute&& compute)
    -> std::optional<std::invoke_result_t<Compute&>> {
    const auto add = [&](const std::string& reason) {
        findings.push_back({code, severity, "no " + what + ": " + reason});
    };
    try {
        return compute();
    } catch (const InputError& error) {
        add(error.problem());
    } catch (const ConvergenceError& error) {
        add(error.what());
    }
    return std::nullopt;
}

}  // namespace ashimpact
