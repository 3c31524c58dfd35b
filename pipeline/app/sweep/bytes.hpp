// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ashimpact {

/// Thrown for bytes that no ByteWriter of this program wrote.
class BrokenBytes : public std::runtime_error {
  public:
    BrokenBytes() : std::runtime_error("the bytes end too early or too late") {}
};

/// Copied byte by byte: the same program reads them on the same kind of machine.
template <class Value>
concept PlainValue = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;

/// Writes values one after another. A class is written, and read, through its member transfer(archive).
class ByteWriter {
  public:
    void operator()(auto&... values) { (write(values), ...); }
    [[nodiscard]] std::string take() && { return std::move(bytes_); }

  private:
    template <PlainValue Value>
    void write(const Value& value) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + sizeof(Value));
        std::memcpy(bytes_.data() + at, &value, sizeof(Value));
    }
    void write(std::string& text) {
        write(std::uint64_t{text.size()});
        bytes_ += text;
    }
    template <class Element>
    void write(std::vector<Element>& elements) {
        write(std::uint64_t{elements.size()});
        for (Element& element : elements) write(element);
    }
    template <class Value>
    requires(!PlainValue<Value>) void write(Value& value) { value.transfer(*this); }

    std::string bytes_;
};

/// Reads what a ByteWriter wrote. @throws BrokenBytes
class ByteReader {
  public:
    explicit ByteReader(std::string_view bytes) : left_(bytes) {}

    void operator()(auto&... values) { (read(values), ...); }
    /// @throws BrokenBytes if bytes are left
    void finish() const {
        if (!left_.empty()) throw BrokenBytes();
    }

  private:
    std::string_view take(std::uint64_t count) {
        if (count > left_.size()) throw BrokenBytes();
        const std::string_view taken = left_.substr(0, count);
        left_.remove_prefix(count);
        return taken;
    }
    template <PlainValue Value>
    void read(Value& value) {
        std::memcpy(&value, take(sizeof(Value)).data(), sizeof(Value));
    }
    void read(std::string& text) {
        std::uint64_t size = 0;
        read(size);
        text = take(size);
    }
    template <class Element>
    void read(std::vector<Element>& elements) {
        std::uint64_t size = 0;
        read(size);
        if (size > left_.size()) throw BrokenBytes();  // every element takes a byte or more
        elements.resize(size);
        for (Element& element : elements) read(element);
    }
    template <class Value>
    requires(!PlainValue<Value>) void read(Value& value) { value.transfer(*this); }

    std::string_view left_;
};

/// Values as bytes.
template <class... Values>
[[nodiscard]] std::string packed(Values... values) {
    ByteWriter writer;
    writer(values...);
    return std::move(writer).take();
}

/// The value that packed() made into these bytes. @throws BrokenBytes
template <class Value>
[[nodiscard]] Value unpacked(std::string_view bytes) {
    Value value{};
    ByteReader reader(bytes);
    reader(value);
    reader.finish();
    return value;
}

}  // namespace ashimpact
