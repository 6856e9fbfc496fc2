#pragma once

namespace wheelrail
{
  /// What supports the rail.
  enum class RailSupport
  {
    clamped_foot,    ///< foot and ends do not move
    continuous_pads, ///< the pads spread evenly along the rail, on rigid ground; free ends
    sleepers         ///< pads on sleepers; free ends
  };

  /// How the loss factor of a pad depends on frequency.
  enum class PadLoss
  {
    damper,  ///< in proportion: one damper, matched at one frequency
    constant ///< constant from 100 to 2000 Hz: three Maxwell branches
  };

  /// Track/Support and its entries [SI].
  struct SupportData
  {
    RailSupport kind                 = RailSupport::clamped_foot;
    double      spacing              = 0.6;   ///< of sleepers
    double      first_sleeper        = 0.3;   ///< Z of the middle of one of them; the start is at 0
    double      pad_length           = 0.15;  ///< along the rail
    double      pad_stiffness        = 300e6; ///< of one pad, normal to the foot, at `pad_frequency`
    double      pad_lateral          = 40e6;
    double      pad_longitudinal     = 40e6;
    PadLoss     pad_damping          = PadLoss::damper;
    double      pad_loss             = 0.25; ///< loss factor at `pad_frequency`
    double      pad_frequency        = 500;  ///< [Hz]
    double      sleeper_mass         = 160;  ///< below one rail; infinite: sleepers that do not move
    double      ballast_stiffness    = 50e6; ///< below one end of a sleeper, vertical
    double      ballast_lateral      = 25e6;
    double      ballast_longitudinal = 25e6;
    double      ballast_loss         = 1; ///< at `ballast_frequency`, by one damper
    double      ballast_frequency    = 100;
    double      damped_ends          = 0; ///< stretch at either end of the rail with mass damping
  };
} // namespace wheelrail
