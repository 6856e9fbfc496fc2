#include <wheelrail/base/choices.h>
#include <wheelrail/base/errors.h>
#include <wheelrail/base/format_text.h>
#include <wheelrail/base/interrupt.h>
#include <wheelrail/base/progress.h>
#include <wheelrail/base/quantity.h>
#include <wheelrail/commands/report_script.h>
#include <wheelrail/input/listing.h>
#include <wheelrail/input/without_effect.h>
#include <wheelrail/model/scene_checks.h>
#include <wheelrail/model/scene_material.h>
#include <wheelrail/output/figure_table.h>
#include <wheelrail/output/folder.h>
#include <wheelrail/output/replace_file.h>
#include <wheelrail/receptance/hammer_places.h>
#include <wheelrail/receptance/receptance_command.h>
#include <wheelrail/receptance/response_tables.h>
#include <wheelrail/receptance/spectra.h>
#include <wheelrail/receptance/track_waves.h>
#include <wheelrail/track/scene_track.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <vector>

namespace wheelrail
{
  namespace
  {
    /// What is struck, and how.
    struct ReceptanceOptions
    {
      Body        body    = Body::rail;
      bool        lateral = false;
      std::string at;               ///< as rail_places() has it
      double      duration = 40e-3; ///< of the record [s]
      std::string beside;           ///< file of another result, or empty
      bool        waves = true;     ///< of a rail also by the waves of its section
      bool        draws = true;
    };

    constexpr double lowest_hz = 20, highest_hz = 5000;

    void
    print_peaks(const std::vector<Resonance> &peaks, std::ostream &out)
    {
      out << "\nResonances, peaks of the mobility:\n   frequency     mobility   loss factor\n"
             "          Hz      m/(N s)\n";
      for (const Resonance &peak : peaks)
        {
          out << text("%12.1f %12.3e", peak.frequency, peak.mobility);
          if (std::isfinite(peak.loss))
            out << text("%14.3f", peak.loss);
          out << '\n';
        }
    }

    /// Largest and mean difference of the mobilities at the frequencies of the waves [dB].
    void
    print_difference(const FigureTable      &blow,
                     const FigureTable      &waves,
                     nlohmann::ordered_json &summary,
                     std::ostream           &out)
    {
      const auto &f = *blow.find("frequency_Hz"), &a = *blow.find("mobility_m_per_Ns");
      const auto &g = *waves.find("frequency_Hz"), &b = *waves.find("mobility_m_per_Ns");
      double      most = 0, at = 0, sum = 0;
      for (std::size_t k = 0; k < g.size(); ++k)
        {
          const auto   row  = std::lower_bound(f.begin(), f.end(), g[k] * (1 - 1e-9)) - f.begin();
          const double away = 20 * std::log10(a[row] / b[k]);
          sum += std::abs(away) / g.size();
          if (std::abs(away) > std::abs(most))
            most = away, at = g[k];
        }
      summary["waves_mean_difference_dB"]       = sum;
      summary["waves_largest_difference_dB"]    = most;
      summary["waves_largest_difference_at_Hz"] = at;
      out << '\n'
          << text(
               "By waves of the section: mobility differs by %.1f dB in the mean, by %.1f dB at most (%.0f "
               "Hz)\n",
               sum,
               most,
               at);
    }

    void
    print_start(const TrackSettings     &scene,
                const LoneBody          &body,
                const ReceptanceOptions &options,
                const RailPlaces        &places,
                std::ostream            &out)
    {
      const bool rail = options.body == Body::rail;
      if (rail && scene.support.damped_ends == 0)
        out << "note: the rail has no Track/Damped ends, so that waves come back from its ends\n";
      out << (options.lateral ? "Lateral" : "Vertical") << " blow on the " << (rail ? "rail" : "wheel");
      if (rail)
        out << " at " << rounded_mm(places.along);
      out << text(", %zu elements, %.0f time steps of %.3f us\n",
                  body.solid.quality.elements,
                  options.duration / body.time_step,
                  1e6 * body.time_step)
          << std::flush;
    }

    /// What a blow gave.
    struct Struck
    {
      const Receptances            &blow;
      const FigureTable            &table;
      const std::vector<Resonance> &peaks;
    };

    /// The same by the waves of the rail's section: waves.csv, the largest difference, and the peak that
    /// record and rail cut most.
    void
    hold_against_waves(const Scene                 &scene,
                       const ReceptanceOptions     &options,
                       const LoneBody              &body,
                       const RailPlaces            &places,
                       const Struck                &struck,
                       const std::filesystem::path &folder,
                       nlohmann::ordered_json      &summary,
                       std::ostream                &out)
    {
      const TrackWaves  waves(body.plan.rail,
                             elasticity(scene.rail_material),
                             scene.support.kind,
                             track_data(scene, body.plan.start_block * body.plan.block_length()),
                             places.faces);
      const FigureTable second = make_waves_table(waves, struck.blow, places.distance);
      second.write_csv((folder / "waves.csv").string());
      print_difference(struck.table, second, summary, out);
      if (const auto cut = most_cut(struck.peaks, waves, struck.blow.fading))
        {
          summary["cut_peak_Hz"] = cut->frequency;
          summary["cut_peak_dB"] = cut->decibel;
          out << cut_note(*cut, options.duration, scene.rail_length) << '\n';
        }
      if (scene.support.kind == RailSupport::sleepers)
        {
          summary["pinned_pinned_Hz"] = waves.pinned_pinned();
          out << "Pinned-pinned (a wave of two bays on the unsupported rail): "
              << std::lround(waves.pinned_pinned()) << " Hz\n";
        }
    }

    void
    print_fading(const Receptances &blow, std::ostream &out)
    {
      if (blow.fading > 0)
        out << text(
          "note: %.0f %% of the motion is left at the end of the record; it is faded, which makes "
          "peaks %.0f Hz broader; --duration takes a longer record\n",
          100 * blow.left,
          blow.fading / M_PI);
    }

    int
    run_receptance_command(const Scene             &scene,
                           const SceneGeometry     &geometry,
                           const ReceptanceOptions &options,
                           std::ostream            &out)
    {
      const ResultFolder           held(scene.folder, "-receptance");
      const std::filesystem::path &folder = held.path();
      const bool                   rail   = options.body == Body::rail;
      std::string                  beside = options.beside.empty() ? "" : beside_text(options.beside, out);
      const auto                   body   = make_lone_body(scene, geometry, options.body, MPI_COMM_WORLD);
      RailPlaces                   places;
      if (rail)
        places = rail_places(scene, body->plan.rail, options.at, options.lateral);
      else
        places.faces = wheel_faces(geometry, options.lateral);
      print_start(scene, *body, options, places, out);
      Progress         progress;
      const BlowRecord record =
        strike(scene, *body, places.faces, options.duration, MPI_COMM_WORLD, [&](const double share) {
          if (progress.due())
            out << progress.at(share) << std::endl;
        });
      const Receptances blow  = receptances(record, 1, lowest_hz, highest_hz);
      const FigureTable table = make_response_table(blow.frequency, blow.of_face, places.distance);
      const auto        peaks = resonances(blow.frequency, *table.find("mobility_m_per_Ns"));
      print_peaks(peaks, out);

      nlohmann::ordered_json summary = {{"title", scene.title},
                                        {"program_version", WHEELRAIL_VERSION},
                                        {"body", rail ? "rail" : "wheel"},
                                        {"direction", options.lateral ? "lateral" : "vertical"},
                                        {"at_m", rail ? nlohmann::ordered_json(places.along) : nullptr},
                                        {"duration_s", options.duration},
                                        {"time_steps", record.time_steps},
                                        {"elements", body->solid.quality.elements},
                                        {"energy_error", record.energy_error},
                                        {"left_at_the_end", blow.left},
                                        {"fading_per_s", blow.fading}};
      for (const char *const old : {"waves.csv", "beside.csv"})
        std::filesystem::remove(folder / old);
      if (rail && options.waves)
        hold_against_waves(scene, options, *body, places, {blow, table, peaks}, folder, summary, out);
      print_fading(blow, out);
      replace_file((folder / "parameters.prm").string(), print_parameters(scene));
      table.write_csv((folder / "receptance.csv").string());
      table.write_hdf5((folder / "receptance.h5").string());
      make_resonance_table(peaks).write_csv((folder / "resonances.csv").string());
      if (!beside.empty())
        replace_file((folder / "beside.csv").string(), beside);
      replace_file((folder / "summary.json").string(), summary.dump(2) + "\n");
      out << "Results in " << folder.string() << std::endl;
      if (options.draws)
        draw_results("receptance.py", folder.string());
      return 0;
    }


    /// The value of an option that is one of some words; the first of them where it is not given.
    std::string
    word_of(const po::variables_map &options, const std::string &name, const std::vector<std::string> &words)
    {
      if (!options.count(name))
        return words.front();
      std::string word = options[name].as<std::string>();
      try
        {
          require_choice(word, words);
        }
      catch (const InputError &error)
        {
          throw InputError("--" + name + " " + word + ": " + error.what());
        }
      return word;
    }

    double
    duration_of(const po::variables_map &options)
    {
      const std::string text = options["duration"].as<std::string>();
      double            duration;
      try
        {
          duration = parse_quantity(text, Dimension::time);
        }
      catch (const InputError &error)
        {
          throw InputError("--duration " + text + ": " + error.what());
        }
      if (!(duration >= 5e-3 && duration <= 1))
        throw InputError("--duration " + text + ": not between 5 ms and 1 s");
      return duration;
    }
  } // namespace


  int
  act_receptance(const po::variables_map &options, const RunFunction &, std::ostream &out)
  {
    require_file(options, "receptance", "receptance.prm");
    ReceptanceOptions given;
    given.body    = word_of(options, "body", {"rail", "wheel"}) == "rail" ? Body::rail : Body::wheel;
    given.lateral = word_of(options, "direction", {"vertical", "lateral"}) == "lateral";
    if (options.count("at"))
      given.at = options["at"].as<std::string>();
    if (given.body == Body::wheel && !given.at.empty())
      throw InputError("--at " + given.at + ": a wheel is struck at its contact; leave it out");
    if (options.count("duration"))
      given.duration = duration_of(options);
    if (options.count("beside"))
      given.beside = options["beside"].as<std::string>();
    given.waves      = !options.count("no-waves");
    given.draws      = !options.count("no-pictures");
    SceneInput input = one_scene_of(options);
    print_notes(entries_without_effect(input, "receptance"), out);
    input.scene.irregularities   = {}; // the bodies by themselves are smooth
    const SceneGeometry geometry = require_computable(input);
    return run_receptance_command(input.scene, geometry, given, out);
  }
} // namespace wheelrail
