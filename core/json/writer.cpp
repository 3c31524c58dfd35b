// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json/writer.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "core/text/text.hpp"

namespace ashimpact {

namespace {

constexpr std::size_t line_width = 110;
constexpr std::size_t indent_width = 2;

std::string number(double value, Digits digits) {
    if (!std::isfinite(value)) throw std::logic_error("a result holds a number that is not finite");
    value += 0.0;  // turns -0 into 0
    return digits == Digits::shortest ? shortest(value) : fmt::format("{:.17g}", value);
}

std::string text(const std::string& value) {
    return Json(value).dump(-1, ' ', false, Json::error_handler_t::replace);
}

class Writer {
  public:
    explicit Writer(Digits digits) : digits_(digits) {}

    /// Writes a value whose first line already holds @p used bytes.
    void write(const Json& value, std::size_t indent, std::size_t used) {
        const std::string line = one_line(value, line_width);
        if (!line.empty() && used + line.size() <= line_width)
            out_ += line;
        else if (value.is_object())
            write_object(value, indent);
        else if (value.is_array())
            write_array(value, indent);
        else
            out_ += one_line(value, std::string::npos);
    }

    [[nodiscard]] std::string&& take() && { return std::move(out_); }

  private:
    /// The value in one line, or nothing if that would be longer than @p limit.
    [[nodiscard]] std::string one_line(const Json& value, std::size_t limit) const {
        if (value.is_string()) return text(value.get_ref<const std::string&>());
        if (value.is_number_float()) return number(value.get<double>(), digits_);
        if (!value.is_structured()) return value.dump();
        std::string line(1, value.is_object() ? '{' : '[');
        for (auto element = value.begin(); element != value.end(); ++element) {
            if (element != value.begin()) line += ", ";
            if (value.is_object()) line += text(element.key()) + ": ";
            const std::string inner = one_line(*element, limit);
            if (inner.empty() || line.size() + inner.size() > limit) return {};
            line += inner;
        }
        return line + (value.is_object() ? '}' : ']');
    }

    void new_line(std::size_t indent) { out_ += "\n" + std::string(indent, ' '); }

    void write_object(const Json& object, std::size_t indent) {
        out_ += '{';
        for (auto member = object.begin(); member != object.end(); ++member) {
            if (member != object.begin()) out_ += ',';
            new_line(indent + indent_width);
            const std::string key = text(member.key()) + ": ";
            out_ += key;
            write(*member, indent + indent_width, indent + indent_width + key.size());
        }
        new_line(indent);
        out_ += '}';
    }

    void write_array(const Json& array, std::size_t indent) {
        out_ += '[';
        std::size_t used = line_width;  // the first element begins a line
        for (auto element = array.begin(); element != array.end(); ++element) {
            if (element != array.begin()) out_ += ',';
            const std::string line = element->is_structured() ? "" : one_line(*element, std::string::npos);
            if (line.empty() || used + line.size() + 2 > line_width) {
                new_line(indent + indent_width);
                used = indent + indent_width;
            } else {
                out_ += ' ';
                ++used;
            }
            if (line.empty())
                write(*element, indent + indent_width, used);
            else
                out_ += line;
            used = line.empty() ? line_width : used + line.size() + 1;
        }
        new_line(indent);
        out_ += ']';
    }

    Digits digits_;
    std::string out_;
};

}  // namespace

std::string write_json(const Json& document, Digits digits) {
    Writer writer(digits);
    writer.write(document, 0, 0);
    return std::move(writer).take() + "\n";
}

}  // namespace ashimpact
