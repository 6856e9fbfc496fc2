// label: fast

// Faults of input files of CONTACT, and the message for each.

#include <wheelrail/contactfiles/inp_file.h>

#include "contact_inputs.h"
#include "messages.h"

#include <string>
#include <utility>
#include <vector>

using namespace wheelrail;
using test::basic;
using test::replaced;
using test::same_text;
using test::wheel_rail;

namespace
{
  /// What is said of an input, or that nothing is.
  std::string
  message_of(const std::string &text)
  {
    return test::message_of([&]() { read_inp_text(text, "x.inp"); });
  }

  /// An input with texts replaced, and the line and message of its fault.
  struct Fault
  {
    const std::string                               &text;
    std::vector<std::pair<std::string, std::string>> changes;
    std::string                                      expected;
  };

  void
  check_faults(const std::vector<Fault> &faults)
  {
    for (const Fault &fault : faults)
      {
        std::string text = fault.text, name;
        for (const auto &[from, to] : fault.changes)
          {
            text = replaced(text, from, to);
            name += (name.empty() ? "" : ", ") + ("\"" + to + "\"");
          }
        BOOST_TEST(same_text(message_of(text), "x.inp:" + fault.expected, name));
      }
  }

  /// A file that cannot be read is bad input, not a fault of what is computed.
  void
  test_files_that_are_none()
  {
    BOOST_TEST(same_text(
      test::message_of([]() { read_inp_file("nothing.inp"); }),
      "The file \"nothing.inp\" cannot be read: No such file or directory. An input file of CONTACT "
      "(.inp) is needed.",
      "a file that is not there"));
  }

  void
  test_files_cut_off()
  {
    BOOST_TEST(same_text(
      message_of(""),
      "x.inp:1: the file ends without the line \"0 MODULE\"; it is cut off, or that line is missing behind "
      "the last case",
      "an empty file"));
    BOOST_TEST(same_text(
      message_of(basic.substr(0, basic.find(" -3\n"))),
      "x.inp:34: the file ends within case 3, where IPOTCN should follow; it is cut off, or a digit asks for "
      "values that are not there",
      "a file that is cut off"));
    BOOST_TEST(same_text(
      message_of(basic.substr(0, basic.find("   6 7 8"))),
      "x.inp:17: the file ends within case 1, where the undeformed distance of IBASE = 9 should follow; it "
      "is cut off, or a digit asks for values that are not there",
      "one that is cut off within an array"));
    BOOST_TEST(same_text(
      message_of(
        replaced(basic, "   470.5, -0.00304, 0", "   470.5, -0.00304" + std::string(250, ' ') + "0")),
      "x.inp:7: CETA stands behind the 256 characters that CONTACT reads of a line; write the values in "
      "several lines",
      "a long line"));
  }

  void
  test_faults_of_files()
  {
    check_faults({
      {basic,
       {{"-4.1 -4.2", "-4.1-4.2 "}},
       "13: \"-4.1-4.2\" stands where XL should; numbers without a blank between them: separate them"},
      {basic,
       {{"1 2 3  heights", "1 2 3.-4."}},
       "16: \"3.-4.\" stands where the undeformed distance of IBASE = 9, value 3 of 6 should; numbers "
       "without a blank between them: separate them"},
      {basic,
       {{"   4 5\n", "   four 5\n"}},
       "17: \"four\" stands where the undeformed distance of IBASE = 9, value 4 of 6 should; a number is "
       "needed"},
      {basic,
       {{"0.4013  0.4013", "0.4013  0.4013 1.5-2.5"}},
       "8: \"1.5-2.5\" are numbers without a blank between them: separate them"},
      {basic,
       {{"0.4013  0.4013", "        0.4013"}},
       "8: FKIN is missing: \"FSTAT\" stands in its place, and \"180.d\" begins line 9, where it could "
       "follow"},
      {basic, {{"100.0", "100.5"}}, "6: MAXIN = 100.5 is no integer"},
      {basic,
       {{"180.d", "180.x"}},
       "9: \"180.x\" stands where CHI should; an angle such as 0.02 (rad) or 1.5d (degrees) is needed"},
      {basic,
       {{"  022020", "  02202x"}},
       "4: \"02202x\" stands where the digits VLDCMZE should; at most 7 digits in one word are needed"},
      {basic,
       {{"  022020", "00022020"}},
       "4: \"00022020\" stands where the digits VLDCMZE should; at most 7 digits in one word are needed"},
      {basic,
       {{" 3  MODULE", " 2  MODULE"}},
       "2: MODULE 2 is unknown; 1 (wheel and rail), 3 (basic contact) or 0 (end of the file) is needed; "
       "digit R of the case before tells whether a MODULE line follows"},
      {basic,
       {{" 3  MODULE", " 3 1000 MODULE"}},
       "2: result element 1000, contact problem 0; elements from 1 to 999 and problems from 1 on are needed"},
      {basic,
       {{" 3  MODULE", " % MODULE"}},
       "3: MODULE 203100 is unknown; 1 (wheel and rail), 3 (basic contact) or 0 (end of the file) is needed; "
       "digit R of the case before tells whether a MODULE line follows"},
      {wheel_rail,
       {{"'contact_inp_file/wheel.prw'", "contact_inp_file/wheel.prw"}},
       "18: \"contact_inp_file/wheel.prw\" stands where WFNAME should; a text in single quotation marks is "
       "needed, 'name'"},
      {wheel_rail,
       {{"/wheel.prw", "/whel.prw"}},
       "18: the profile \"contact_inp_file/whel.prw\" is not there: no file contact_inp_file/whel.prw; paths "
       "of profiles count from the folder of the input file"},
      {wheel_rail,
       {{"contact_inp_file/wheel.prw", "contact_inp_file"}},
       "18: the profile \"contact_inp_file\" is no file, but a folder"},
    });
  }

  void
  test_faults_of_digits()
  {
    check_faults({
      {basic,
       {{"  203100 ", "  205100 "}},
       "3: the digit T = 5 (motion) is unknown; it may be 0 (no friction), 1 (shift), 2 (transient rolling) "
       "or 3 (steady rolling)"},
      {basic,
       {{"  203100 ", " 3203100 "}},
       "3: \"3203100\" stands where the digits PBTNFS should; at most 6 digits in one word are needed"},
      {basic,
       {{"  022020 ", "  722020 "}},
       "4: the digit L = 7 (friction law) is unknown; it may be 0 (Coulomb), 1 (as before), 2 (linear in the "
       "slip velocity), 3 (rational), 4 (exponential) or 6 (by temperature)"},
      {basic,
       {{"  022020 ", "  122020 "}},
       "4: the digit L = 1 (friction law) keeps what the case before has, but case 1 is the first one; write "
       "one of 0 (Coulomb), 2 (linear in the slip velocity), 3 (rational), 4 (exponential) or 6 (by "
       "temperature)"},
      {basic, {{"  203100 ", "  253100 "}}, "3: B = 5 and 6 need N = 0 (approach given)"},
      {basic,
       {{"  203100 ", "  223100 "}},
       "3: B = 2 and 3 (given pressure) need a Hertzian contact, IPOTCN = -6 to -1"},
      {basic, {{"  203100 ", "  243100 "}}, "3: B = 4 and IPOTCN = -6 (two half ellipses) need each other"},
      {basic,
       {{"  400000\n", "  420200\n"}},
       "28: IPOTCN = 203000 is unknown; -6 to -1 (Hertzian contact) or 1 to 4 (a grid) is needed"},
      {basic,
       {{"  400000\n", "  400400\n"}},
       "23: M = 4 has no constants: C = 0 keeps those of M = 0; set C = 2 and state them"},
      {basic,
       {{"  022020 ", "  022120 "}},
       "11: FG1 FG2 TC1 TC2 go on to line 13, which has more numbers than they take: a value is missing, or "
       "digits ask for other values"},
      {basic,
       {{"  203120\n  400000", "  202120\n  400100"}},
       "23: M = 1 (viscoelastic) needs T = 3 (steady rolling)"},
      {basic,
       {{"  022020 ", "  024020 "}, {"   .28     .27 ", " 1 3 0\n .28 .27 "}},
       "10: NN, the number of points of the surface of C = 4, is not positive"},
      {basic,
       {{"  022020 ", "  024020 "}, {"   .28     .27 ", " 1 3 2\n 1 0\n 1 0.1\n .28 .27 "}},
       "12: Y of the surface of C = 4 does not ascend"},
      {basic,
       {{"  022020 ", "  622020 "}},
       "8: DFHEAT is missing: \"FSTAT\" stands in its place, and \"180.d\" begins line 9, where it could "
       "follow"},
      {basic,
       {{"0001341 ", "3001341 "}},
       "11: BKTEMP HEATCP LAMBDA DENS go on to line 13, which has more numbers than they take: a value is "
       "missing, or digits ask for other values"},
      {basic,
       {{"  203120\n  400000", "  203120\n 3100000"}},
       "23: the digit V may not change where L = 1 keeps the friction of the case before"},
      {basic,
       {{" 0122020 12", " 3122020   "}},
       "35: a grid of MX x MY elements needs from 1 to 1000000 of them"},
      {basic, {{" -3\n 11 13", " -5\n 11 13"}}, "36: IPOTCN = -4 and -5 need N = 1 (force given)"},
      {wheel_rail, {{" 1203110", " 1203010"}}, "3: F = 1 (FX_WS given) needs N = 1 (force given)"},
      {wheel_rail,
       {{" 1022033", " 1022023"}},
       "13: VZRAIL is missing: \"GAUGHT\" stands in its place, and \"contact_inp_file\\rail of 54.prr\" "
       "begins "
       "line 14, where it could follow"},
      {wheel_rail,
       {{" 1022033", " 1022032"}},
       "17: ROLL is missing: the line ends, and \"contact_inp_file/wheel.prw\" begins line 18, where it "
       "could "
       "follow"},
      {wheel_rail,
       {{" 1203100\n 1111002", " 1002100\n 1121002"}},
       "26: DX, DS and DQREL, the size of the elements and of a step, are not positive"},
    });
  }

  void
  test_faults_of_values()
  {
    check_faults({
      {basic,
       {{"  022020 ", "  422020 "}, {"0.4013  0.4013 ", "0.2 0.1 0 0 0\n 0 1 %"}},
       "8: SH1 or SH2, at which half of a term of the friction law is gone, is not positive"},
      {basic,
       {{"-4.1 -4.2", "MX   4.2"}},
       "12: XL is missing: the line ends, and \"MX\" begins line 13, where it could follow"},
      {basic, {{"   470.5,", "  -470.5,"}}, "7: FN is not positive, as a force that presses is"},
      {basic, {{"   470.5,", "       0,"}}, "7: FN is not positive, as a force that presses is"},
      {basic,
       {{"0.4013  0.4013", "0.4013  0.4   "}},
       "8: FSTAT and FKIN differ; Coulomb's law (L = 0) needs equal ones"},
      {basic,
       {{"180.d   0.2  ", "180.d   0    "}},
       "9: DQ and VELOC, the rolled distance of a step and the velocity, are not positive"},
      {basic,
       {{".28     .27", ".28     .57"}},
       "10: Poisson's ratios POISS1, POISS2 are not from 0 to 0.5, or the shear moduli GG1, GG2 are not "
       "positive"},
      {basic,
       {{"    1        ", "    5        "}},
       "11: IPOTCN = 5 is unknown; -6 to -1 (Hertzian contact) or 1 to 4 (a grid) is needed"},
      {basic,
       {{"   3    2 ", "   3    0 "}},
       "12: a grid of MX x MY elements needs from 1 to 1000000 of them"},
      {basic,
       {{"0.2  0.3", "0.2 -0.3"}},
       "12: a size among XL YL DX DY is not positive, or the corners are not in order"},
      {basic,
       {{"   9    1 ", "   4    1 "}},
       "15: IBASE = 4 is unknown; 1 (quadratic), 2 (profile and radius), 3 (waves) or 9 (by elements) is "
       "needed"},
      {basic,
       {{"   9    1 ", "   9    5 "}},
       "15: IPLAN = 5 is unknown; 1 (all elements), 2 (quadratic), 3 (two rectangles) or 4 (patches) is "
       "needed"},
      {basic,
       {{"   9    1 ", "   9    4 "}, {"   6 7 8\n", "   6 7 8\n 1\n"}},
       "20: NPATCH, the patches of IPLAN = 4, is not from 2 to 100"},
      {basic,
       {{"   9    1 ", "   2 1\n 1 0 300 0 1\n"}},
       "16: the profile of IBASE = 2 needs two heights or more, a positive step DY1 and a radius RM other "
       "than 0"},
      {basic,
       {{"   9    1 ", "   3 1\n 1 1 1 1 1 1 0 1\n"}},
       "16: B7 or B8 is 0; x and y squared are divided by them"},
      {wheel_rail,
       {{"  2           ", "  11          "}},
       "8: NVF, the lines of the friction variation, is not from 1 to 10"},
      {wheel_rail,
       {{"-0.1r", "-0.5r"}},
       "10: the lines of the friction variation do not rise in their first value"},
      {wheel_rail,
       {{"0.200   0.300   1.000", "0.200   0.000   1.000"}},
       "12: DX, DS and DQREL, the size of the elements and of a step, are not positive"},
      {wheel_rail,
       {{"10000.", "-1000."}},
       "19: FZ is negative; a force that presses wheel and rail together counts positive"},
      {wheel_rail,
       {{"wheel.prw'   0     1.0", "wheel.prw'   0     0.0"}},
       "18: SCALE of a profile is not positive"},
    });
  }

  /// Cases that keep what the case before has, or state what others need.
  void
  test_faults_of_several_digits()
  {
    check_faults({
      {basic,
       {{"   3    2 ", "  30    2 "},
        {"   1 2 3  heights",
         "  1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 "
         "1 1 1"}},
       "16: more than the 50 numbers that CONTACT reads of a line; write them in several lines"},
      {basic,
       {{"  022020 ", "  622020 "}, {"0.4013  0.4013 ", "0.3 0 -0.18 400\n 0 1 % "}},
       "4: L = 6 (friction by temperature) needs H = 1 or 3 and none of M = 2, 3, 5"},
      {basic,
       {{"0001341", "3001341"},
        {"820d2  8.1E+04  POISS 1,2,  GG 1,2", "82000 81000\n 0 450 0 7e-6\n 0 450 .05 7e-6"}},
       "11: HEATCP, LAMBDA and DENS, what a body takes up of heat, are not positive"},
      {basic,
       {{"  022020 ", "  022120 "}, {"820d2  8.1E+04  POISS 1,2,  GG 1,2", "82000 81000\n 1 1 0 0"}},
       "9: M = 1 (viscoelastic) needs CHI = 0"},
      {basic,
       {{"  203100 ", "  201100 "},
        {"0001341", "3001341"},
        {"   180.d   0.2   1000.          CHI, DQ, VELOC\n", ""},
        {"820d2  8.1E+04  POISS 1,2,  GG 1,2", "82000 81000\n 0 450 .05 7e-6\n 0 450 .05 7e-6"}},
       "5: H = 3 (heat) needs T = 0 (no friction) or 3 (steady rolling)"},
      {basic,
       {{"  400000\n", "  420000\n"},
        {"   0.001 10.           MEMDST, MEM_S0\n",
         "   0.001 10.           MEMDST, MEM_S0\n 1\n 3 2 0 0 1 1\n"}},
       "23: D = 1 and 2 (potential contact) need Z = 2 (undeformed distance)"},
      {basic,
       {{"  203120\n  400000", "  003120\n  420020"},
        {"   0.001 10.           MEMDST, MEM_S0\n",
         "   0.001 10.           MEMDST, MEM_S0\n 1\n 3 2 0.15 0 .2 .3\n 1 1\n 0 0 0 0 0 0\n"}},
       "29: the grid is not that of the case before, shifted by whole elements; P = 0, 1, 3 and I = 1, 2, 3 "
       "need it"},
      {basic,
       {{"  022020 ", "  022029 "},
        {"   6 7 8\n", "   6 7 8\n 1 2 3 4 5 6 7 8 9 10 11 12\n"},
        {"  400000\n", "  420021\n"},
        {"   0.001 10.           MEMDST, MEM_S0\n",
         "   0.001 10.           MEMDST, MEM_S0\n 1\n 2 2 0 0 1 1\n 1 1\n 0 0 0 0 0 0\n"}},
       "30: the grid has not as many elements as the extra rigid slip kept of the case before"},
      {basic,
       {{"  400000\n", "  420010\n"},
        {"   0.001 10.           MEMDST, MEM_S0\n",
         "   0.001 10.           MEMDST, MEM_S0\n 1\n 2 2 0 0 1 1\n"}},
       "29: the grid has not as many elements as the undeformed distance kept of the case before"},
      {basic,
       {{"  022020 ", " 3022020 "},
        {"   0.4013  0.4013               FSTAT, FKIN\n", ""},
        {"   6 7 8\n", "   6 7 8\n .3 .3\n .4 .4\n"},
        {"  400000\n", " 3120020\n"},
        {"   0.18 0.12 1250. 0.03 1000.   FKIN,FEXP1,SH1,F2,SH2\n   0.001 10.           MEMDST, MEM_S0\n",
         " 1\n 3 3 0 0 1 1\n 1 1\n 0 0 0 0 0 0\n"}},
       "28: the grid has not as many rows as the friction kept of the case before"},
      {basic,
       {{"    1                           IPOTCN\n   3    2    % mx, my\n  -4.1 -4.2  % xl, yl\n   0.2  0.3  "
         " dx, dy\n   9    1                       IBASE, IPLAN\n   1 2 3  heights\n   4 5\n\n   6 7 8\n",
         " -3\n 3 2 4 2 1.1\n"},
        {"  400000\n", "  420010\n"},
        {"   0.001 10.           MEMDST, MEM_S0\n",
         "   0.001 10.           MEMDST, MEM_S0\n 1\n 2 2 0 0 1 1\n"}},
       "16: no case has stated the undeformed distance; set Z = 2 and state it"},
      {basic,
       {{"  203100 ", "  201100 "}, {"   180.d   0.2   1000.          CHI, DQ, VELOC\n", ""}},
       "22: no case has stated CHI, DQ and VELOC, which rolling (T = 2, 3) needs; set C = 2 and state them"},
      {basic,
       {{"  022020", "  622020"}, {"   0.4013  0.4013", "   0.4 20. 0. 0."}},
       "8: FREF or DTHEAT, the friction and the range of temperatures over which it changes, is not "
       "positive"},
      {basic,
       {{"  203100 ", "  203103 "}, {"   6 7 8\n", "   6 7 8\n 2 4\n 4\n"}},
       "21: ISUBS = 4 is unknown; 1, 2, 3, 5, 6, 7, 9 (points below the surface) or 0 (no more) is needed"},
      {basic,
       {{"  203100 ", "  203103 "}, {"   6 7 8\n", "   6 7 8\n 2 4\n 1\n -3 0 1\n"}},
       "22: counts of points below the surface are not from 0 to 1000000"},
      {wheel_rail,
       {{" 1203100\n 1111002", " 1002100\n 1121002"},
        {"  0.0  1.0  20000.", "  0.3 0.3 1 90d 6 3\n  0.0  1.0  20000."}},
       "26: DX and DS may not change where shifts and transient rolling go on"},
      {wheel_rail,
       {{" 1022033", " 1022023"},
        {"   14.0     0    1435.0   0.025           GAUGHT, GAUGSQ, GAUGWD, CANT\n  'contact_inp_file\\rail "
         "of 54.prr'   0     1.0   0.0 0 1\n   0  150d   30d   6d   2.0\n",
         ""}},
       "4: no case has stated the track and the profile of the rail; set Z = 3 and state them"},
      {wheel_rail,
       {{" 1022033", " 1022032"},
        {"  1360.0  -70.0   460.0\n  'contact_inp_file/wheel.prw'   0     1.0   0.0      % it's a wheel\n",
         ""}},
       "4: no case has stated the wheelset and the profile of the wheel; set E = 3 and state them"},
    });
  }
} // namespace


BOOST_AUTO_TEST_CASE(contact_inp_faults)
{
  test::make_profiles();
  test_files_that_are_none();
  test_files_cut_off();
  test_faults_of_files();
  test_faults_of_digits();
  test_faults_of_several_digits();
  test_faults_of_values();
}
