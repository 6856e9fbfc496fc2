#include <wheelrail/input/entry_kinds.h>
#include <wheelrail/input/section_entries.h>

#include <optional>
#include <vector>

namespace wheelrail
{
  namespace
  {
    using S = Scene;

    void
    add_elements(EntryList &list)
    {
      const ElementForm reduced = ElementForm::reduced, full = ElementForm::full;
      list.choice<ElementForm>("Element",
                               {{"reduced", reduced}, {"full", full}},
                               field(&Scene::element),
                               "Element form; reduced: one integration point, stabilised by assumed strain; "
                               "full: eight points with the mean dilatation, about twice the work.");
      using Form = std::optional<ElementForm>;
      for (const bool rail : {true, false})
        list.choice<Form>(rail ? "Rail element" : "Wheel element",
                          {{"as Element", {}}, {"reduced", reduced}, {"full", full}},
                          field(rail ? &Scene::rail_element : &Scene::wheel_element),
                          rail ? "Element form of the rail alone." : "Element form of the wheel alone.");
    }
  } // namespace


  std::vector<Entry>
  mesh_entries()
  {
    EntryList list("Mesh");
    list.number({"Solution cell size", "mm", "0.1 mm", "16 mm"},
                field(&S::cell_size),
                "Edge of the cells in and around the patch.");
    list.number({"Coarse cell size", "mm", "0.2 mm", "64 mm"},
                field(&S::coarse_cell_size),
                "Edge of the cells far from the patch; 2, 4, 8, ... solution cells.");
    list.number({"Fine depth", "mm", "0.1 mm", "50 mm"},
                field(&S::fine_depth),
                "Depth of the layer of solution cells below both running surfaces; auto: five cells.",
                {{"auto", 0}});
    list.number({"Fine margin", "mm", "0.1 mm", "50 mm"},
                field(&S::fine_margin),
                "Solution cells reach this far beyond the expected patch.");
    list.number({"Planned load", "kN", "1 kN", "1000 kN"},
                field(&S::planned_load),
                "Wheel load for whose patch the solution cells are placed; auto: that of the scene. For runs "
                "of several loads over one rail: the largest.",
                {{"auto", 0}});
    list.numbers(
      {"Planned strip", "mm", "-60 mm", "60 mm"},
      2,
      field(&S::planned_strip),
      "Two places on the rail's section, positive to the field side, between which solution cells "
      "are placed; none: around the patch of the scene. For wheels at several places of one rail.");
    list.number({"Prepared distance", "mm", "> 0 mm", "10 m"},
                field(&S::prepared_distance),
                "With Window = fixed: the mesh is made for rolling that far, so that a run can be resumed "
                "with a longer one; auto: Run/Rolling distance, until steady Run/Longest distance.",
                {{"auto", 0}});
    list.choice<MeshWindow>("Window",
                            {{"moving", MeshWindow::moving}, {"fixed", MeshWindow::fixed}},
                            field(&S::window),
                            "Where the solution cells lie; moving: around the wheel, with which they go from "
                            "block to block; fixed: all along the rolled distance.");
    list.choice<BehindWheel>(
      "Behind the wheel",
      {{"auto", BehindWheel::automatic}, {"coarsen", BehindWheel::coarsen}, {"keep", BehindWheel::keep}},
      field(&S::behind_wheel),
      "What becomes of solution cells that a moving window leaves behind; auto: those that have flowed "
      "plastically stay, the others are made coarse again.");
    list.choice<bool>(
      "Mass scaling",
      {{"true", true}, {"false", false}},
      field(&S::mass_scaling),
      "Denser steel in cells stiffer than a cube, whose time step then holds; what is added is told.");
    add_elements(list);
    return list.entries;
  }
} // namespace wheelrail
