// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <hdf5.h>

namespace ashimpact::hdf5 {

/// A failed call of HDF5. Its own messages are long and would go to standard error, see silence().
class Hdf5Error : public std::runtime_error {
  public:
    explicit Hdf5Error(const char* what) : std::runtime_error(std::string("HDF5: ") + what + " failed") {}
};

/// @throws Hdf5Error for a negative status
void check(herr_t status, const char* what);

/// Owns an HDF5 identifier.
class Handle {
  public:
    using Close = herr_t (*)(hid_t);

    Handle(hid_t id, Close closer, const char* what) : id_(id), close_(closer) {
        if (id < 0) throw Hdf5Error(what);
    }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    Handle& operator=(Handle&&) = delete;
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    [[nodiscard]] hid_t id() const { return id_; }
    /// Closes it now. @throws Hdf5Error if not all was written
    void close(const char* what) { check(close_(std::exchange(id_, -1)), what); }

  private:
    hid_t id_;
    Close close_;
};

/// Stops HDF5 from writing messages to standard error, and from its clean-up at exit, which would crash when
/// it writes again what a full disk refused before. Every file is closed explicitly, so no clean-up is
/// needed. To be called before anything else of HDF5.
void silence();
/// A property list without time stamps.
[[nodiscard]] Handle timeless(hid_t kind);
/// Adds a text to a file, group or dataset.
void add_attribute(hid_t object, const char* name, const std::string& value);

}  // namespace ashimpact::hdf5
