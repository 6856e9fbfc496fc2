#include <wheelrail/output/descriptions.h>
#include <wheelrail/output/hdf5_handles.h>
#include <wheelrail/output/slice_file.h>

#include <cstdint>

namespace wheelrail
{
  namespace
  {
    struct Field
    {
      const char *name, *unit;
    };
    /// The last one only in a body that may flow.
    constexpr Field fields[] = {{"von_mises_stress", "Pa"},
                                {"stress_xx", "Pa"},
                                {"stress_yy", "Pa"},
                                {"stress_zz", "Pa"},
                                {"stress_yz", "Pa"},
                                {"stress_xz", "Pa"},
                                {"stress_xy", "Pa"},
                                {"plastic_strain", "1"}};
  } // namespace


  void
  append_slices(TickFile &file, const double time, const double travelled, const std::vector<Slice> &slices)
  {
    using namespace hdf5;
    file.append(time, travelled, [&](const std::int64_t tick) {
      for (const Slice &slice : slices)
        {
          const Handle group(H5Gcreate2(tick, slice.name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Gclose,
                             "make the group " + slice.name);
          const bool   along = slice.name[0] == 'A';
          write_attribute(group, along ? "lateral_m" : "along_m", slice.offset);
          write_attribute(group, "position_is", std::string(along ? "along" : "lateral"));
          write_dataset(
            group, "position", {slice.position.size()}, slice.position, "m", description_of("position"));
          write_dataset(group, "depth", {slice.depth.size()}, slice.depth, "m", description_of("depth"));
          for (std::size_t f = 0; f < slice.values.size(); ++f)
            {
              const char *const name =
                f == 0 && slice.unloaded ? "residual_von_mises_stress" : fields[f].name;
              write_dataset(group,
                            name,
                            {slice.position.size(), slice.depth.size()},
                            slice.values[f],
                            fields[f].unit,
                            description_of(name));
            }
          if (!slice.forward_shear.empty())
            write_dataset(group,
                          "forward_shear",
                          {slice.position.size(), slice.depth.size()},
                          slice.forward_shear,
                          "1",
                          description_of("forward_shear"));
        }
    });
  }
} // namespace wheelrail
