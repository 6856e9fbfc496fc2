#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <optional>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using B = Bounds;
    using S = Scene;

    /// A length, or "auto", stored as 0.
    Entry
    length_or_auto(const EntryHead &head, const Bounds &bounds, const Field<double> &place)
    {
      return with_word(length_entry(head, "mm", bounds, place), "auto", 0, place);
    }

    void
    add_elements(std::vector<Entry> &list)
    {
      const ElementForm reduced = ElementForm::reduced, full = ElementForm::full;
      list.push_back(choice_entry<ElementForm>(
        {"Mesh",
         "Element",
         "Element form; reduced: one integration point, stabilised by assumed strain; "
         "full: eight points with the mean dilatation, about twice the work."},
        {{"reduced", reduced}, {"full", full}},
        field(&Scene::element)));
      using Form = std::optional<ElementForm>;
      for (const bool rail : {true, false})
        list.push_back(
          choice_entry<Form>({"Mesh",
                              rail ? "Rail element" : "Wheel element",
                              rail ? "Element form of the rail alone." : "Element form of the wheel alone."},
                             {{"as Element", {}}, {"reduced", reduced}, {"full", full}},
                             field(rail ? &Scene::rail_element : &Scene::wheel_element)));
    }
  } // namespace


  std::vector<Entry>
  mesh_entries()
  {
    std::vector<Entry> list;
    list.push_back(length_entry({"Mesh", "Solution cell size", "Edge of the cells in and around the patch."},
                                "mm",
                                B::between("0.1 mm", "16 mm"),
                                field(&S::cell_size)));
    list.push_back(length_entry(
      {"Mesh", "Coarse cell size", "Edge of the cells far from the patch; 2, 4, 8, ... solution cells."},
      "mm",
      B::between("0.2 mm", "64 mm"),
      field(&S::coarse_cell_size)));
    list.push_back(
      length_or_auto({"Mesh",
                      "Fine depth",
                      "Depth of the layer of solution cells below both running surfaces; auto: five cells."},
                     B::between("0.1 mm", "50 mm"),
                     field(&S::fine_depth)));
    list.push_back(
      length_entry({"Mesh", "Fine margin", "Solution cells reach this far beyond the expected patch."},
                   "mm",
                   B::between("0.1 mm", "50 mm"),
                   field(&S::fine_margin)));
    list.push_back(
      with_word(number_entry({"Mesh",
                              "Planned load",
                              "Wheel load for whose patch the solution cells are laid; auto: that of "
                              "the scene. For runs of several loads over one rail: the largest."},
                             Dimension::force,
                             "kN",
                             B::between("1 kN", "1000 kN"),
                             field(&S::planned_load)),
                "auto",
                0,
                field(&S::planned_load)));
    list.push_back(list_entry(
      {"Mesh",
       "Planned strip",
       "Two places on the rail's section, positive to the field side, between which solution cells "
       "are laid; none: around the patch of the scene. For wheels at several places of one rail."},
      Dimension::length,
      "mm",
      B::between("-60 mm", "60 mm"),
      2,
      field(&S::planned_strip)));
    list.push_back(length_or_auto(
      {"Mesh",
       "Prepared distance",
       "With Window = fixed: the mesh is made for rolling that far, so that a run can be "
       "resumed with a longer one; auto: Run/Rolling distance, until steady Run/Longest distance."},
      B::above("0 mm", "10 m"),
      field(&S::prepared_distance)));
    list.push_back(choice_entry<MeshWindow>(
      {"Mesh",
       "Window",
       "Where the solution cells lie; moving: around the wheel, with which they go from block to block; "
       "fixed: all along the rolled distance."},
      {{"moving", MeshWindow::moving}, {"fixed", MeshWindow::fixed}},
      field(&S::window)));
    list.push_back(choice_entry<BehindWheel>(
      {"Mesh",
       "Behind the wheel",
       "What becomes of solution cells that a moving window leaves behind; auto: those that have flowed "
       "plastically stay, the others are made coarse again."},
      {{"auto", BehindWheel::automatic}, {"coarsen", BehindWheel::coarsen}, {"keep", BehindWheel::keep}},
      field(&S::behind_wheel)));
    add_elements(list);
    return list;
  }
} // namespace wheelrail
