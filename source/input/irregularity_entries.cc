#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <string>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using I = IrregularityData;
    using K = IrregularKind;

    template <typename T>
    Field<T>
    field_of(const int number, T I::*member)
    {
      return [number, member](Scene &scene) -> T & { return scene.irregularities[number].*member; };
    }

    std::vector<Entry>
    entries_of(const int k)
    {
      EntryList list("Irregularity " + std::to_string(k + 1));
      list.choice<K>(
        "Kind",
        {{"none", K::none},
         {"dent", K::dent},
         {"squat", K::squat},
         {"corrugation", K::corrugation},
         {"weld", K::weld},
         {"dipped joint", K::dipped_joint},
         {"flat", K::flat},
         {"rounded flat", K::rounded_flat},
         {"polygon", K::polygon},
         {"roughness", K::roughness},
         {"file", K::file}},
        field_of(k, &I::kind),
        "Shape that the running surface has besides its profile. squat: two lobes; weld: hollow or bump all "
        "across; dipped joint: rail ends that hang down, with a kink; flat: fresh wheel flat with edges; "
        "rounded flat: one that is rolled round; roughness: waves of a spectrum; file: measured heights or "
        "slices.");
      list.choice<IrregularBody>(
        "Body",
        {{"auto", IrregularBody::automatic}, {"rail", IrregularBody::rail}, {"wheel", IrregularBody::wheel}},
        field_of(k, &I::body),
        "What it lies on; auto: the wheel for flats, polygons and files .slcw, else the rail.");
      list.number(
        {"Place", "mm", "-10 m", "10 m"},
        field_of(k, &I::place),
        "Along the track from the contact point of the start, where its middle lies (of a corrugation or "
        "polygon: a crest; of a file: its origin). On the wheel: the place along the track where it comes "
        "into contact in rolling. A wheel with a Run/Start offset meets those of the rail as much earlier.");
      list.number({"Lateral place", "mm", "-80 mm", "80 mm"},
                  field_of(k, &I::lateral),
                  "Of its middle in the section of the body, positive to the field side of the rail's axis "
                  "or the running circle; contact: where wheel and rail touch (of a file: 0 mm).",
                  {{"contact", I::automatic}});
      list.number({"Length", "mm", "1 mm", "10 m"},
                  field_of(k, &I::length),
                  "Along the track; of a corrugation that of all waves; of roughness that of its whole "
                  "height, on both sides of which it fades.");
      list.number({"Width", "mm", "1 mm", "200 mm"},
                  field_of(k, &I::width),
                  "Across the track; whole: alike all across.",
                  {{"whole", 0.}});
      list.number({"Depth", "mm", "-5 mm", "5 mm"},
                  field_of(k, &I::depth),
                  "Largest, below the smooth surface; of waves from crest to trough; negative: raised. auto: "
                  "of a flat length^2/(8 R), of a rounded one half of it, of a dipped joint from its angle.",
                  {{"auto", I::automatic}});
      list.number({"Wavelength", "mm", "2 mm", "1 m"}, field_of(k, &I::wavelength), "Of a corrugation.");
      list.number({"Angle", "mrad", "> 0 mrad", "100 mrad"},
                  field_of(k, &I::angle),
                  "Of a dipped joint in place of its depth: how much the surface turns at the joint, both "
                  "sides together, 8 depth/length.",
                  {{"none", I::automatic}});
      list.count({"Order", 1, 100}, field_of(k, &I::order), "Of a polygon: waves around the wheel.");
      list.count({"Seed", 1, 1000000},
                 field_of(k, &I::seed),
                 "Of roughness: another one gives other phases of the same spectrum.");
      list.name_or_file(
        "File",
        {"none"},
        "a file (with its ending, such as squat.csv)",
        field_of(k, &I::file),
        "Of Kind = file: heights over the profile, on a grid (along_mm, across_mm, height_um; CSV or HDF5) "
        "or along a line (along_mm, height_um), or slices as CONTACT reads them (.slcs of a rail, .slcw of a "
        "wheel). Of Kind = roughness: levels of one-third-octave bands (wavelength_mm, level_dB).");
      for (Entry &entry : list.entries)
        entry.repeats = k > 0;
      return list.entries;
    }
  } // namespace


  std::vector<Entry>
  irregularity_entries()
  {
    std::vector<Entry> list;
    for (int k = 0; k < most_irregularities; ++k)
      for (Entry &entry : entries_of(k))
        list.push_back(std::move(entry));
    return list;
  }
} // namespace wheelrail
