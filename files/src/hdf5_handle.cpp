#include "hdf5_handle.h"

#include <glift/error.h>

namespace glift::files {

namespace {

std::recursive_mutex mutex;

herr_t note_innermost(unsigned, const H5E_error2_t* error, void* text) {
    *static_cast<std::string*>(text) =
        std::string(error->func_name ? error->func_name : "") + ": " + (error->desc ? error->desc : "");
    return 0;
}

Id half_type() {
    Id type(H5Tcopy(H5T_IEEE_F32LE), "H5Tcopy");
    check(H5Tset_fields(type, 15, 10, 5, 0, 10), "H5Tset_fields");
    check(H5Tset_size(type, 2), "H5Tset_size");
    check(H5Tset_ebias(type, 15), "H5Tset_ebias");
    return type;
}

Id bool_type() {
    Id type(H5Tenum_create(H5T_STD_I8LE), "H5Tenum_create");
    const signed char no = 0, yes = 1;
    check(H5Tenum_insert(type, "FALSE", &no), "H5Tenum_insert");
    check(H5Tenum_insert(type, "TRUE", &yes), "H5Tenum_insert");
    return type;
}

hid_t standard_type(Scalar scalar) {
    switch (scalar) {
    case Scalar::int8: return H5T_STD_I8LE;
    case Scalar::int16: return H5T_STD_I16LE;
    case Scalar::int32: return H5T_STD_I32LE;
    case Scalar::int64: return H5T_STD_I64LE;
    case Scalar::uint8: return H5T_STD_U8LE;
    case Scalar::uint16: return H5T_STD_U16LE;
    case Scalar::uint32: return H5T_STD_U32LE;
    case Scalar::uint64: return H5T_STD_U64LE;
    case Scalar::float32: return H5T_IEEE_F32LE;
    case Scalar::float64: return H5T_IEEE_F64LE;
    case Scalar::boolean:
    case Scalar::flag:
    case Scalar::float16: return -1;
    }
    return -1;
}

}  // namespace

Hdf5Lock::Hdf5Lock() : lock_(mutex) { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

void throw_hdf5(const char* call) {
    std::string text;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, note_innermost, &text);
    throw Error(ErrorCode::wrong_argument, "HDF5 refused a call", call, text,
                "where the disk is full, make room; else report it as a bug of Glift");
}

Id file_type(Scalar scalar) {
    if (scalar == Scalar::boolean || scalar == Scalar::flag) return bool_type();
    if (scalar == Scalar::float16) return half_type();
    return Id(H5Tcopy(standard_type(scalar)), "H5Tcopy");
}

std::size_t file_bytes(Scalar scalar) {
    switch (scalar) {
    case Scalar::boolean:
    case Scalar::flag:
    case Scalar::int8:
    case Scalar::uint8: return 1;
    case Scalar::int16:
    case Scalar::uint16:
    case Scalar::float16: return 2;
    case Scalar::int32:
    case Scalar::uint32:
    case Scalar::float32: return 4;
    case Scalar::int64:
    case Scalar::uint64:
    case Scalar::float64: return 8;
    }
    return 1;
}

Id simple_space(const std::vector<hsize_t>& extent) {
    if (extent.empty()) return Id(H5Screate(H5S_SCALAR), "H5Screate");
    return Id(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), "H5Screate_simple");
}

void write_attribute(hid_t object, const std::string& name, Scalar scalar, const std::vector<hsize_t>& extent,
                     const void* numbers) {
    const Id type = file_type(scalar), space = simple_space(extent);
    const Id attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), "H5Acreate2");
    check(H5Awrite(attribute, type, numbers), "H5Awrite");
}

void write_attribute(hid_t object, const std::string& name, const std::string& text) {
    const Id type(H5Tcopy(H5T_C_S1), "H5Tcopy");
    check(H5Tset_size(type, text.size() + 1), "H5Tset_size");
    check(H5Tset_cset(type, H5T_CSET_UTF8), "H5Tset_cset");
    const Id space = simple_space({});
    const Id attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), "H5Acreate2");
    check(H5Awrite(attribute, type, text.c_str()), "H5Awrite");
}

std::string read_text_attribute(hid_t object, const std::string& name) {
    const Id attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), "H5Aopen");
    const Id type(H5Aget_type(attribute), "H5Aget_type");
    std::string text(H5Tget_size(type), '\0');
    check(H5Aread(attribute, type, text.data()), "H5Aread");
    text.resize(text.find('\0') == std::string::npos ? text.size() : text.find('\0'));
    return text;
}

}  // namespace glift::files
