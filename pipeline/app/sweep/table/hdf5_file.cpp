// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/table/hdf5_file.hpp"

namespace ashimpact::hdf5 {

void check(herr_t status, const char* what) {
    if (status < 0) throw Hdf5Error(what);
}

void silence() {
    static const herr_t no_clean_up = H5dont_atexit();  // refused from the second time on
    check(no_clean_up, "H5dont_atexit");
    check(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "H5Eset_auto");
}

Handle timeless(hid_t kind) {
    Handle properties(H5Pcreate(kind), H5Pclose, "H5Pcreate");
    check(H5Pset_obj_track_times(properties.id(), false), "H5Pset_obj_track_times");
    return properties;
}

void add_attribute(hid_t object, const char* name, const std::string& value) {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "H5Tcopy");
    check(H5Tset_size(type.id(), value.size() + 1), "H5Tset_size");
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "H5Screate");
    const Handle attribute(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose, "H5Acreate");
    check(H5Awrite(attribute.id(), type.id(), value.c_str()), "H5Awrite");
}

}  // namespace ashimpact::hdf5
