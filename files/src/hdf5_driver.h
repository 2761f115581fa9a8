// HDF5's way to a file that is being written: its metadata through the page cache, chunks of elements past it. HDF5's
// own driver would copy all into the cache.
#pragma once

#include "dataset.h"

namespace glift::files {

/// Creates a file whose bytes HDF5 gives to `data`, which a shared pointer owns. The file is empty so far.
Id create_hdf5(DataMap& data);

}  // namespace glift::files
