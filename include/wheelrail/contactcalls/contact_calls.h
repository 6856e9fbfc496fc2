/* Functions of the library contact_addon_linux64.so: those of CONTACT's library, revision 2707, with its
   names, arguments and unit conventions (doc/manual/contact.md). Plain C; all arguments are pointers. ire is
   a result element, 1 to 999; icp a contact problem, from 1, or -1 for wheel and rail as a whole. */
#ifndef WHEELRAIL_CONTACT_CALLS_H
#define WHEELRAIL_CONTACT_CALLS_H

#ifdef __cplusplus
extern "C"
{
#endif

  /* start and end */
  void
  cntc_initializefirst(int        *version,
                       int        *error,
                       const int  *output,
                       const char *folder,
                       const char *name,
                       const int  *folder_length,
                       const int  *name_length);
  void
  cntc_initializefirst_new(int        *version,
                           int        *error,
                           const int  *output,
                           const char *work_folder,
                           const char *folder,
                           const char *name,
                           const int  *work_folder_length,
                           const int  *folder_length,
                           const int  *name_length);
  void
  cntc_initialize(const int  *ire,
                  const int  *module,
                  int        *version,
                  int        *error,
                  const char *folder,
                  const int  *folder_length);
  void
  cntc_finalize(const int *ire);
  void
  cntc_finalizelast(void);
  void
  cntc_readinpfile(const int *ire, const int *kind, const char *name, const int *name_length, int *error);

  /* flags, solver, material, friction */
  void
  cntc_setglobalflags(const int *n, const int *codes, const int *values);
  void
  cntc_setflags(const int *ire, const int *icp, const int *n, const int *codes, const int *values);
  void
  cntc_setmetadata(const int *ire, const int *icp, const int *n, const int *codes, const double *values);
  void
  cntc_setsolverflags(const int    *ire,
                      const int    *icp,
                      const int    *G,
                      const int    *n_integers,
                      const int    *integers,
                      const int    *n_reals,
                      const double *reals);
  void
  cntc_setmaterialparameters(const int    *ire,
                             const int    *icp,
                             const int    *M,
                             const int    *n,
                             const double *values);
  void
  cntc_setmaterialproperties(const int    *ire,
                             const int    *icp,
                             const double *shear1,
                             const double *poisson1,
                             const double *shear2,
                             const double *poisson2);
  void
  cntc_setinterfaciallayer(const int *ire, const int *icp, const int *M, const int *n, const double *values);
  void
  cntc_settemperaturedata(const int *ire, const int *icp, const int *H, const int *n, const double *values);
  void
  cntc_setfrictionmethod(const int *ire, const int *icp, const int *VL, const int *n, const double *values);

  /* rolling, grid, distance, forces, creepages */
  void
  cntc_settimestep(const int *ire, const int *icp, const double *seconds);
  void
  cntc_setreferencevelocity(const int *ire, const int *icp, const double *velocity);
  void
  cntc_setrollingstepsize(const int *ire, const int *icp, const double *chi, const double *dq);
  void
  cntc_sethertzcontact(const int *ire, const int *icp, const int *ipotcn, const int *n, const double *values);
  void
  cntc_setpotcontact(const int *ire, const int *icp, const int *ipotcn, const int *n, const double *values);
  void
  cntc_setundeformeddistc(const int    *ire,
                          const int    *icp,
                          const int    *ibase,
                          const int    *n,
                          const double *values);
  void
  cntc_setverticalforce(const int *ire, const double *fz);
  void
  cntc_setpenetration(const int *ire, const int *icp, const double *approach);
  void
  cntc_setnormalforce(const int *ire, const int *icp, const double *fn);
  void
  cntc_settangentialforces(const int *ire, const int *icp, const double *fx, const double *fy);
  void
  cntc_setcreepages(const int *ire, const int *icp, const double *vx, const double *vy, const double *phi);
  void
  cntc_setextrarigidslip(const int *ire, const int *icp, const int *n, const double *wx, const double *wy);

  /* wheel and rail */
  void
  cntc_settrackdimensions(const int *ire, const int *Z, const int *n, const double *values);
  void
  cntc_settrackdimensions_new(const int *ire, const int *Z, const int *n, const double *values);
  void
  cntc_settrackdimensions_old(const int *ire, const int *Z, const int *n, const double *values);
  void
  cntc_setprofileinputfname(const int    *ire,
                            const char   *name,
                            const int    *name_length,
                            const int    *n_integers,
                            const int    *integers,
                            const int    *n_reals,
                            const double *reals);
  void
  cntc_setprofileinputvalues(const int    *ire,
                             const int    *n_points,
                             const double *yz,
                             const int    *n_integers,
                             const int    *integers,
                             const int    *n_reals,
                             const double *reals);
  void
  cntc_setwheelsetdimensions(const int *ire, const int *E, const int *n, const double *values);
  void
  cntc_setwheelsetposition(const int *ire, const int *E, const int *n, const double *values);
  void
  cntc_setwheelsetvelocity(const int *ire, const int *E, const int *n, const double *values);
  void
  cntc_setwheelsetflexibility(const int *ire, const int *E, const int *n, const double *values);

  /* computing */
  void
  cntc_calculate(const int *ire, const int *icp, int *error);
  void
  subs_addblock(const int    *ire,
                const int    *icp,
                const int    *block,
                const int    *isubs,
                const int    *nx,
                const int    *ny,
                const int    *nz,
                const double *x,
                const double *y,
                const double *z);
  void
  subs_calculate(const int *ire, const int *icp, int *error);

  /* what was set */
  void
  cntc_getflags(const int *ire, const int *icp, const int *n, const int *codes, int *values);
  void
  cntc_getparameters(const int *ire, const int *icp, const int *task, const int *n, double *values);
  void
  cntc_getprofilevalues(const int *ire,
                        const int *task,
                        const int *n_integers,
                        const int *integers,
                        const int *n,
                        double    *values);
  void
  cntc_getprofilevalues_new(const int    *ire,
                            const int    *task,
                            const int    *n_integers,
                            const int    *integers,
                            const int    *n_reals,
                            const double *reals,
                            const int    *n,
                            double       *values);
  void
  cntc_getwheelsetposition(const int *ire, const int *n, double *values);
  void
  cntc_getwheelsetvelocity(const int *ire, const int *n, double *values);

  /* results */
  void
  cntc_getnumcontactpatches(const int *ire, int *n);
  void
  cntc_getcontactlocation(const int *ire, const int *icp, const int *n, double *values);
  void
  cntc_getreferencevelocity(const int *ire, const int *icp, double *velocity);
  void
  cntc_gethertzcontact(const int *ire, const int *icp, const int *n, double *values);
  void
  cntc_getnumelements(const int *ire, const int *icp, int *mx, int *my);
  void
  cntc_getgriddiscretization(const int *ire, const int *icp, double *dx, double *dy);
  void
  cntc_getpotcontact(const int *ire, const int *icp, const int *n, double *values);
  void
  cntc_getpenetration(const int *ire, const int *icp, double *approach);
  void
  cntc_getcreepages(const int *ire, const int *icp, double *vx, double *vy, double *phi);
  void
  cntc_getcontactforces(const int *ire, const int *icp, double *fn, double *fx, double *fy, double *mz);
  void
  cntc_getglobalforces(const int *ire, const int *icp, const int *n, double *values);
  void
  cntc_getcontactpatchareas(const int *ire, const int *icp, double *contact, double *adhesion, double *slip);
  void
  cntc_getelementdivision(const int *ire, const int *icp, const int *n, int *states);
  void
  cntc_getmaximumpressure(const int *ire, const int *icp, double *pressure);
  void
  cntc_getmaximumtraction(const int *ire, const int *icp, double *traction);
  void
  cntc_getmaximumtemperature(const int *ire, const int *icp, double *body1, double *body2);
  void
  cntc_getfielddata(const int *ire, const int *icp, const int *field, const int *n, double *values);
  void
  cntc_gettractions(const int *ire, const int *icp, const int *n, double *pn, double *px, double *py);
  void
  cntc_getmicroslip(const int *ire, const int *icp, const int *n, double *sx, double *sy);
  void
  cntc_getdisplacements(const int *ire, const int *icp, const int *n, double *un, double *ux, double *uy);
  void
  cntc_getsensitivities(const int *ire, const int *icp, const int *n_out, const int *n_in, double *values);
  void
  cntc_getcalculationtime(const int *ire, const int *icp, double *cpu, double *wall);
  void
  cntc_resetcalculationtime(const int *ire, const int *icp);
  void
  subs_getblocksize(const int *ire, const int *icp, const int *block, int *nx, int *ny, int *nz);
  void
  subs_getresults(const int *ire,
                  const int *icp,
                  const int *block,
                  const int *n_points,
                  const int *n_columns,
                  const int *columns,
                  double    *values);

#ifdef __cplusplus
}
#endif
#endif
