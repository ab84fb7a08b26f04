// HDF5: the datasets have the names of the .npz file, metadata are attributes of the root group.
#include <utility>

#include "aktina/base/error.h"
#include "aktina/export/hdf5_library.h"
#include "aktina/export/view_factor_files.h"

namespace aktina {
namespace {

/// An open object of the library, closed when it goes; a failed call says so.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) throw Error(Code::io, "", "the HDF5 file cannot be written", "is the disk full?");
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void check(herr_t status) {
  if (status < 0) throw Error(Code::io, "", "the HDF5 file cannot be written", "is the disk full?");
}

hid_t type_of(const double*) { return H5T_NATIVE_DOUBLE; }
hid_t type_of(const float*) { return H5T_NATIVE_FLOAT; }
hid_t type_of(const uint64_t*) { return H5T_NATIVE_UINT64; }
hid_t type_of(const uint32_t*) { return H5T_NATIVE_UINT32; }

/// Without times of making, so that the same matrix gives the same bytes.
class Dataset {
 public:
  Dataset(hid_t file, const char* name, hid_t type, hid_t space)
      : settings_(H5Pcreate(H5P_DATASET_CREATE), H5Pclose), set_(made(file, name, type, space), H5Dclose) {}
  operator hid_t() const { return set_; }

 private:
  hid_t made(hid_t file, const char* name, hid_t type, hid_t space) const {
    check(H5Pset_obj_track_times(settings_, false));
    return H5Dcreate2(file, name, type, space, H5P_DEFAULT, settings_, H5P_DEFAULT);
  }
  Handle settings_, set_;
};

hid_t utf8_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

template <class Values>
void add(hid_t file, const char* name, const Values& values, std::vector<hsize_t> shape) {
  const Handle space(H5Screate_simple(int(shape.size()), shape.data(), nullptr), H5Sclose);
  const hid_t type = type_of(values.data());
  const Dataset set(file, name, type, space);
  check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
}

void add_names(hid_t file, const std::vector<std::string>& names) {
  std::vector<const char*> pointers;
  for (const std::string& name : names) pointers.push_back(name.c_str());
  const hsize_t count = names.size();
  const Handle type(utf8_type(), H5Tclose), space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Dataset set(file, "names", type, space);
  check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()));
}

void add_attribute(hid_t file, const std::string& name, const std::string& value) {
  const char* text = value.c_str();
  const Handle type(utf8_type(), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  check(H5Awrite(attribute, type, &text));
}

/// N x N by rows, so that no second matrix is needed.
void add_dense(hid_t file, const ViewFactors& f) {
  const hsize_t n = f.size(), shape[] = {n, n}, one[] = {1, n};
  const Handle space(H5Screate_simple(2, shape, nullptr), H5Sclose), row(H5Screate_simple(2, one, nullptr), H5Sclose);
  const Dataset set(file, "F", H5T_NATIVE_DOUBLE, space);
  for (hsize_t i = 0; i < n; ++i) {
    const hsize_t from[] = {i, 0};
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, from, nullptr, one, nullptr));
    check(H5Dwrite(set, H5T_NATIVE_DOUBLE, row, space, H5P_DEFAULT, dense_row(f, i).data()));
  }
}

void add_sparse(hid_t file, const ViewFactors& f) {
  add(file, "indptr", f.starts, {f.starts.size()});
  add(file, "indices", f.columns, {f.columns.size()});
  add(file, "data", f.factors, {f.factors.size()});
  add(file, "errors", f.errors, {f.errors.size()});
  add(file, "shape", std::vector<uint64_t>{f.size(), f.size()}, {2});
  add_attribute(file, "format", "csr");
}

void add_gray(hid_t file, const ViewFactorFile& data) {
  const hsize_t n = data.factors.size();
  if (data.exchange) {
    add(file, "script_F", data.exchange->script_f, {n, n});
    add(file, "gebhart", data.exchange->gebhart, {n, n});
  }
  if (data.bodies) {
    std::vector<double> emissivities;
    for (const GrayBody& body : *data.bodies) emissivities.push_back(body.emissivity);
    add(file, "emissivities", emissivities, {n});
  }
  if (data.balance) {
    add(file, "temperatures", data.balance->temperatures, {n});
    add(file, "radiosities", data.balance->radiosities, {n});
    add(file, "fluxes", data.balance->fluxes, {n});
  }
}

void write(const Path& path, const ViewFactorFile& data) {
  const Handle file(H5Fcreate(display(path).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  data.factors.size() <= kMostDense ? add_dense(file, data.factors) : add_sparse(file, data.factors);
  add(file, "areas", data.factors.areas, {data.factors.size()});
  const std::vector<double>& passing = data.factors.transmittances;
  if (!passing.empty()) add(file, "transmittances", passing, {passing.size()});
  add_names(file, data.factors.names);
  const std::vector<uint8_t>& complete = data.factors.complete;
  if (!complete.empty())
    add(file, "complete", std::vector<uint64_t>(complete.begin(), complete.end()), {complete.size()});
  add_gray(file, data);
  add_attribute(file, "certificate", data.certificate);
  for (const auto& [name, value] : data.metadata) add_attribute(file, name, value);
  check(H5Fflush(file, H5F_SCOPE_LOCAL));
}

}  // namespace

void write_hdf5(const Path& path, const ViewFactorFile& file) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // the library must not print
  write_through(path, [&](const Path& temporary) { write(temporary, file); });
}

}  // namespace aktina
