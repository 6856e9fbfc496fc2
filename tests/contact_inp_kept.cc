// label: fast

// Faults of cases of CONTACT's input files that keep what the case before has, or states what others need,
// and the message for each.

#include "inp_faults.h"

using test::basic;
using test::check_faults;
using test::wheel_rail;

int
main()
{
  test::make_profiles();
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
  return test::report();
}
