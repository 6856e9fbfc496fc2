#pragma once

#include <string>

namespace wheelrail
{
  /// What a run begins with, of the steady rolling that the half-space theory predicts.
  enum class StartState
  {
    steady_rolling,     ///< creepage, tractions, and the velocities of fields that travel with the contact
    without_creepage,   ///< the wheel turns at V / R
    without_tractions,  ///< no shear traction
    without_velocities, ///< rail at rest, wheel turning as a rigid body
    normal_load         ///< none of the three
  };

  /// Which wheel passes when one has passed before.
  enum class NextWheel
  {
    fresh, ///< a new one
    same   ///< the one before, with what it has yielded
  };

  /// From what the intervals of a run's results follow.
  enum class ErrorEstimate
  {
    model,     ///< true bodies, and what calibration knows of cells
    two_meshes ///< also the same run on cells twice as large
  };

  /// Distance, passages, start and time step, as in subsection Run.
  struct RunSettings
  {
    static constexpr double at_largest_force = -1; ///< for evaluate_at: around the largest vertical force

    StartState    start            = StartState::steady_rolling;
    double        rolling_distance = 0.06; ///< [m], 0: until steady
    double        longest_distance = 0.06; ///< of a run until steady [m]
    double        standard_error   = 1e-3; ///< that its results may have, over their scales (see Steadiness)
    double        wanted_accuracy  = 0.05; ///< share within which intervals and gaps of models are trusted
    ErrorEstimate error_estimate   = ErrorEstimate::model;
    double        averaging_distance = 0.02; ///< stretch over which the figures are means [m]
    double        evaluate_at        = 0;    ///< its middle [m]; 0: it is the last one
    double        time_step_factor   = 0.95; ///< fraction of the stable step
    double        bulk_viscosity     = 0.06; ///< linear bulk viscosity coefficient
    unsigned int  passages           = 1;    ///< how often the wheels go over the same rail; 0: until steady
    unsigned int  most_passages      = 50;   ///< of wheels, until steady
    double        settled_growth     = 1e-5; ///< of strain in a round, below which nothing grows any more
    double        settled_change     = 0.03; ///< of the growth from round to round, below which it is steady
    std::string   passage_list       = "none"; ///< file of the wheels of a round, or none: one as the scene
    NextWheel     next_wheel         = NextWheel::fresh;
    std::string   rail_from          = "new"; ///< folder of the run that left the rail, or new
    double        start_offset       = 0;     ///< how much farther along the rail the wheel starts [m]
    unsigned int  staggered_starts   = 0;     ///< places where passages start, 0: two where there is room
    double        energy_limit       = 0.005; ///< energy error at which the run stops

    /// How far the wheel rolls, at most where the run ends by itself [m].
    double
    path() const
    {
      return rolling_distance > 0 ? rolling_distance : longest_distance;
    }

    /// Whether more than one wheel passes, or wheels of a list.
    bool
    several_passages() const
    {
      return passages != 1 || passage_list != "none";
    }
  };

  /// What a run writes, as in subsection Output.
  struct OutputSettings
  {
    std::string  folder              = "output/scene";
    unsigned int ticks               = 20; ///< evenly spaced outputs of patch and surface fields over the run
    bool         volume_fields       = true; ///< VTU of the whole mesh at start and end
    double       checkpoint_interval = 0;    ///< between two saved states [s], 0: see SavedStates
  };
} // namespace wheelrail
