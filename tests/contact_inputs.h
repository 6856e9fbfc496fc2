#pragma once

// Input files of CONTACT for tests of what reads them.

#include "near.h"

#include <filesystem>
#include <fstream>
#include <string>

namespace test
{
  // Three cases of basic contact: rolling by creepages, the same with forces and its own friction, a Hertzian
  // contact of the same materials.
  inline const std::string basic = R"(% a remark
 3  MODULE
  203100      P-B-T-N-F-S       PVTIME, BOUND
  022020      L-D-C-M-Z-E
 0001341    H-G-I-A-O-W-R
   999   100.0   30  1  .1-07   MAXGS , MAXIN , MAXNR , MAXOUT, EPS
   470.5, -0.00304, 0, 1e-4     FN, CKSI, CETA, CPHI
   0.4013  0.4013               FSTAT, FKIN
   180.d   0.2   1000.          CHI, DQ, VELOC
   .28     .27   820d2  8.1E+04  POISS 1,2,  GG 1,2
    1                           IPOTCN
   3    2    % mx, my
  -4.1 -4.2  % xl, yl
   0.2  0.3   dx, dy
   9    1                       IBASE, IPLAN
   1 2 3  heights
   4 5

   6 7 8
% Case 2
 3  MODULE
  203120
  400000
 0101340
   500.  0.5 -0.25 0   FN, FX, FY, CPHI
   0.18 0.12 1250. 0.03 1000.   FKIN,FEXP1,SH1,F2,SH2
   0.001 10.           MEMDST, MEM_S0
  203000
 0122020 12
  100241
   0.01 0 0 0 0.5 1.5
  0 0.4 2000. 0.25
  .3 .3 1 1
  1 2 3 4  CDAMPN CDAMPT
 -3
 11 13  4.0 2.0 1.1
 0 MODULE
 this is not read
)";

  inline const std::string wheel_rail = R"(
 1  7  MODULE
 1203110    C-P-B-T-N-F-S
 1022033    V-L-D-C-M-Z-E
10001321  X-H-G-I-A-O-W-R
 1000005    P-S-F-L-C-I-N
    999     100    30    1     1e-5   40000
  2                                       NVF
  -20d    0.200   0.200                   ALPHA, FSTAT, FKIN
  -0.1r   0.300   0.300
  0.280   0.280   82000.  82000.
  0.200   0.300   1.000   90d   6.0   3.0 DX, DS, DQREL, A_SEP, D_SEP, D_COMB
   14.0     0    1435.0   0.025           GAUGHT, GAUGSQ, GAUGWD, CANT
  'contact_inp_file\rail of 54.prr'   0     1.0   0.0 0 1
   0  150d   30d   6d   2.0
     0.0    0.5   0.001   0.0   0.0   0.000
  1360.0  -70.0   460.0
  'contact_inp_file/wheel.prw'   0     1.0   0.0      % it's a wheel
  0.0  0.5  10000.  % S, Y, FZ
 -1.5d 0.0012  0.0  ROLL, YAW, PITCH
 2000. 0.0    0.0  0.0        0.0  -500.
 1  7  MODULE
 1203100
 1111002
 0101321
  0.0  1.0  20000. 0  0.0024  0.0
 2000. 0.0    0.0   0.0        0.0  -4.34
 0
)";

  /// Makes the profiles that the latter names.
  inline void
  make_profiles()
  {
    std::filesystem::create_directories("contact_inp_file");
    std::ofstream("contact_inp_file/rail of 54.prr") << "0 0\n";
    std::ofstream("contact_inp_file/wheel.prw") << "0 0\n";
  }

  inline std::string
  replaced(std::string text, const std::string &from, const std::string &to)
  {
    const std::size_t at = text.find(from);
    BOOST_TEST((at != std::string::npos), "the input holds " + from);
    return text.replace(at, from.size(), to);
  }
} // namespace test
