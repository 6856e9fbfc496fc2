#include <wheelrail/application/command_actions.h>
#include <wheelrail/application/commands.h>
#include <wheelrail/receptance/receptance_command.h>
#include <wheelrail/vehicle/vehicle_command.h>
#include <wheelrail/wear/wear_command.h>

#include <boost/program_options/value_semantic.hpp>

namespace wheelrail
{
  namespace
  {
    namespace po = boost::program_options;

    void
    add_set_option(po::options_description &options)
    {
      options.add_options()("set",
                            po::value<std::vector<std::string>>()->composing(),
                            "\"Section/Entry = value\": change an entry, may be given several times");
    }

    void
    add_no_pictures_option(po::options_description &options)
    {
      options.add_options()("no-pictures", "only results and fields, which takes a second");
    }

    void
    add_bodies_option(po::options_description &options, const std::string &otherwise)
    {
      options.add_options()(
        "bodies",
        po::value<std::string>(),
        ("half-spaces, or real: the true bodies, this wheel and this rail, elastic (default: " + otherwise +
         "); as Half-space/Bodies")
          .c_str());
    }

    void
    add_traction_option(po::options_description &options)
    {
      options.add_options()(
        "traction",
        po::value<std::string>(),
        "\"from scene\": rows without torque, traction or creepage are driven as the scene "
        "says, and do not roll freely");
    }

    void
    add_row_option(po::options_description &options)
    {
      options.add_options()("row",
                            po::value<std::string>(),
                            "the scene at a row of a vehicle simulation, such as prm/s_curve.csv:25");
      add_traction_option(options);
    }
  } // namespace


  const std::vector<Command> &
  commands()
  {
    static const std::vector<Command> list = {
      {"run",
       "FILE.prm",
       "compute the scene of a parameter file",
       [](po::options_description &options) {
         add_set_option(options);
         add_row_option(options);
         options.add_options()("ranks",
                               po::value<std::string>(),
                               "processes; default: the physical cores that are free, as many as the scene "
                               "can use");
         options.add_options()("overwrite", "replace the run in the output folder, finished or saved");
         options.add_options()("resume", "resume from the last saved state in the output folder");
         options.add_options()("validate", "check the file without running");
         options.add_options()(
           "wheelset",
           "roll the modelled wheel as it rolls on its wheelset: the contacts of both wheels "
           "give it load, position and creepage first");
       },
       act_run},
      {"geometry",
       "[FILE.prm]",
       "contact points, angles and rolling radii of the rigid profiles over lateral shifts",
       [](po::options_description &options) {
         add_set_option(options);
         options.add_options()("shifts",
                               po::value<std::string>(),
                               "lateral shifts in mm: first:last:step, or values with commas");
         options.add_options()("places",
                               po::value<std::string>(),
                               "contact points along rails by slices instead: \"0:600:10 mm\"");
         options.add_options()("profiles",
                               "draw both profiles in track position and the undeformed distance into "
                               "FILE_profiles.png here");
       },
       act_geometry},
      {"halfspace",
       "FILE.prm",
       "contact of the scene in seconds, by its true bodies or by half-spaces: patch, tractions, creepage",
       [](po::options_description &options) {
         add_set_option(options);
         add_row_option(options);
         add_no_pictures_option(options);
         add_bodies_option(options, "real, where it can be");
         options.add_options()(
           "creep-curve",
           po::value<std::string>(),
           "forces over creepages or spin instead: \"longitudinal -2:2:0.1 %\", \"lateral ...\", "
           "\"spin -1:1:0.1 1/m\"");
         options.add_options()(
           "beside",
           po::value<std::string>(),
           "with --creep-curve: a table of points, measured or of another program, to draw "
           "beside the curve");
         options.add_options()("places",
                               po::value<std::string>(),
                               "the wheel at rest at places along irregular surfaces (subsections "
                               "Irregularity), or rolling at places along rails by slices, instead: "
                               "\"0:100:5 mm\"");
         options.add_options()(
           "pitch", po::value<std::string>(), "the same at angles of the wheel: \"-7:0:1 deg\"");
         options.add_options()("contact-input",
                               po::value<std::string>(),
                               "also write the problem as input of the program CONTACT, basic module");
         options.add_options()(
           "contact-wheel-rail-input",
           po::value<std::string>(),
           "also write the scene as input of CONTACT's wheel-rail module, with two profile files");
       },
       act_halfspace},
      {"receptance",
       "FILE.prm",
       "a hammer on the unloaded rail, or on the wheel: receptance, mobility, resonances, decay along the "
       "track",
       [](po::options_description &options) {
         add_set_option(options);
         options.add_options()("at",
                               po::value<std::string>(),
                               "where the rail is struck: sleeper (default), between, or a place along the "
                               "track such as \"250 mm\"");
         options.add_options()("direction", po::value<std::string>(), "vertical (default) or lateral");
         options.add_options()("body", po::value<std::string>(), "rail (default) or wheel");
         options.add_options()(
           "duration", po::value<std::string>(), "how long the motion is recorded (default: 40 ms)");
         options.add_options()("beside",
                               po::value<std::string>(),
                               "a table over frequencies to draw beside the result: measured, or the "
                               "receptance.csv of another call");
         options.add_options()("no-waves", "without the waves of the rail's section");
         add_no_pictures_option(options);
       },
       act_receptance},
      {"material",
       "FILE.prm",
       "one point of a steel of the scene, driven through cycles of strain or stress",
       [](po::options_description &options) {
         add_set_option(options);
         add_no_pictures_option(options);
       },
       act_material},
      {"contact",
       "FILE.inp",
       "the cases of an input file of the program CONTACT: wheel and rail, basic contact",
       [](po::options_description &options) {
         options.add_options()("case", po::value<int>(), "one case: its place in the file, from 1");
         options.add_options()("bodies",
                               po::value<std::string>(),
                               "real: cases of wheel and rail by true bodies, too (default: half-spaces)");
         options.add_options()("printed", "CONTACT's own result blocks, too: NAME.out in the results");
         options.add_options()("no-pictures", "tables alone, without pictures and page");
       },
       act_contact},
      {"vehicle",
       "FILE.prm ROWS.csv",
       "the contact in each row of a vehicle simulation: forces, creepages, T-gamma, worst rows",
       [](po::options_description &options) {
         add_set_option(options);
         options.add_options()(
           "motion",
           po::value<std::string>(),
           "the rows: time or distance, lateral shift, roll, yaw, load, velocity, radius, cant, torque "
           "or creepage, with units in the first line");
         options.add_options()("columns",
                               po::value<std::string>(),
                               "a table of names: what a column of the rows is called here, one a line, such "
                               "as \"y_ws;lateral shift [mm]\"");
         options.add_options()(
           "both-wheels", "compute the right and the left wheel, on one axle; as Wheelset/Wheels = both");
         add_traction_option(options);
         add_bodies_option(options, "real");
         add_no_pictures_option(options);
         options.add_options()("overwrite", "start anew where an interrupted call has kept rows");
       },
       act_vehicle},
      {"wear",
       "FILE.prm",
       "profiles of rail and wheel after tonnes or kilometres of a mix of traffic, by half-spaces or "
       "true bodies",
       [](po::options_description &options) {
         add_set_option(options);
         add_bodies_option(options, "half-spaces");
         add_no_pictures_option(options);
         options.add_options()("overwrite", "start anew where the folder holds states of another scene");
       },
       act_wear},
      {"parameters",
       "[FILE.prm]",
       "print all entries with their values, meaning and defaults, as a parameter file",
       [](po::options_description &options) {
         add_set_option(options);
         options.add_options()("validate", "only check the file");
         options.add_options()("json", "print them as JSON, as deal.II's ParameterHandler does");
         options.add_options()("xml", "print them as XML for deal.II's parameter GUI");
         options.add_options()("markdown", "print the table of all entries of doc/manual/parameters.md");
         options.add_options()("ranks",
                               po::value<unsigned int>(),
                               "print on how many processes a run should be started where there are that "
                               "many cores");
       },
       act_parameters},
      {"compare",
       "FOLDER",
       "a finished run against half-spaces under its load and in its position, and against its true bodies",
       [](po::options_description &options) {
         add_set_option(options);
         add_bodies_option(options, "real");
         add_no_pictures_option(options);
       },
       act_compare},
      {"report",
       "FOLDER",
       "pictures and one page from the output folder of a run, halfspace, vehicle, wear, receptance or "
       "material",
       [](po::options_description &options) {
         options.add_options()("tick",
                               po::value<std::string>(),
                               "the output step to draw: a number, or last; several with commas between also "
                               "draw the shear traction at each");
         options.add_options()("csv", "also write histories, maps and sections as tables into FOLDER/csv");
         options.add_options()("each", "of passages also make the page of each");
       },
       act_report},
      {"study",
       "FILE.prm",
       "compute a family of scenes: one table and one page over what varies",
       [](po::options_description &options) {
         add_set_option(options);
         options.add_options()("jobs", po::value<std::string>(), "cases at a time (default: one a core)");
         options.add_options()("ranks", po::value<std::string>(), "processes of each run (default: 1)");
         options.add_options()(
           "profile", po::value<std::string>(), "Snakemake profile of a cluster: slurm, or one of your own");
         options.add_options()("no-pictures", "only tables; the same command without it draws the page");
         options.add_options()("dry-run", "only list the cases and which of them would be computed");
         options.add_options()("plan", "print the cases as JSON");
       },
       act_study},
      {"version",
       "",
       "print the version",
       nullptr,
       [](const po::variables_map &, const RunFunction &, std::ostream &out) {
         out << "wheelrail " << WHEELRAIL_VERSION << "\n";
         return 0;
       }},
    };
    return list;
  }
} // namespace wheelrail
