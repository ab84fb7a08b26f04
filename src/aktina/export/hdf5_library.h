// The HDF5 library, loaded when it is first called: it brings more than thirty libraries with it, half the time in
// which the program starts. Each name hides the library's own within this namespace.
#pragma once

#include <dlfcn.h>
#include <hdf5.h>

#include "aktina/base/error.h"

namespace aktina {

/// The address of something in the library. @throws Error io (the library is not there)
inline void* hdf5_symbol(const char* name) {
  static void* const library = ::dlopen(AKTINA_HDF5_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  void* const symbol = library ? ::dlsym(library, name) : nullptr;
  if (!symbol) throw Error(Code::io, AKTINA_HDF5_LIBRARY, ::dlerror(), "install libhdf5; or another format");
  return symbol;
}

template <class Signature>
class Hdf5Function;

template <class Result, class... Args>
class Hdf5Function<Result(Args...)> {
 public:
  constexpr explicit Hdf5Function(const char* name) : name_(name) {}
  using Pointer = Result (*)(Args...);
  operator Pointer() const { return reinterpret_cast<Pointer>(hdf5_symbol(name_)); }
  Result operator()(Args... args) const { return Pointer(*this)(args...); }

 private:
  const char* name_;
};

/// The number of a type or class, as H5open() sets it.
class Hdf5Id {
 public:
  constexpr explicit Hdf5Id(const char* name) : name_(name) {}
  operator hid_t() const { return *static_cast<const hid_t*>(hdf5_symbol(name_)); }

 private:
  const char* name_;
};

#define AKTINA_HDF5_FUNCTION(name) inline constexpr Hdf5Function<decltype(::name)> name(#name)
AKTINA_HDF5_FUNCTION(H5open);
AKTINA_HDF5_FUNCTION(H5check_version);  // that headers and library fit
AKTINA_HDF5_FUNCTION(H5Aclose);
AKTINA_HDF5_FUNCTION(H5Acreate2);
AKTINA_HDF5_FUNCTION(H5Awrite);
AKTINA_HDF5_FUNCTION(H5Dclose);
AKTINA_HDF5_FUNCTION(H5Dcreate2);
AKTINA_HDF5_FUNCTION(H5Dwrite);
AKTINA_HDF5_FUNCTION(H5Eset_auto2);
AKTINA_HDF5_FUNCTION(H5Fclose);
AKTINA_HDF5_FUNCTION(H5Fcreate);
AKTINA_HDF5_FUNCTION(H5Fflush);
AKTINA_HDF5_FUNCTION(H5Pclose);
AKTINA_HDF5_FUNCTION(H5Pcreate);
AKTINA_HDF5_FUNCTION(H5Pset_obj_track_times);
AKTINA_HDF5_FUNCTION(H5Sclose);
AKTINA_HDF5_FUNCTION(H5Screate);
AKTINA_HDF5_FUNCTION(H5Screate_simple);
AKTINA_HDF5_FUNCTION(H5Sselect_hyperslab);
AKTINA_HDF5_FUNCTION(H5Tclose);
AKTINA_HDF5_FUNCTION(H5Tcopy);
AKTINA_HDF5_FUNCTION(H5Tset_cset);
AKTINA_HDF5_FUNCTION(H5Tset_size);
#undef AKTINA_HDF5_FUNCTION

#define AKTINA_HDF5_ID(name) inline constexpr Hdf5Id name(#name)
AKTINA_HDF5_ID(H5P_CLS_DATASET_CREATE_ID_g);
AKTINA_HDF5_ID(H5T_C_S1_g);
AKTINA_HDF5_ID(H5T_NATIVE_DOUBLE_g);
AKTINA_HDF5_ID(H5T_NATIVE_FLOAT_g);
AKTINA_HDF5_ID(H5T_NATIVE_UINT32_g);
AKTINA_HDF5_ID(H5T_NATIVE_UINT64_g);
#undef AKTINA_HDF5_ID

}  // namespace aktina
