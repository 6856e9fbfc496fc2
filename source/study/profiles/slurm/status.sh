#!/bin/sh
# What has become of a Slurm job, for Snakemake: running, success or failed. A job that Slurm has forgotten ended some
# minutes ago; whether it succeeded tells its record, which Snakemake looks for itself.
state=$(scontrol show job "$1" 2>/dev/null | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p')
case $state in
  PENDING | CONFIGURING | RUNNING | COMPLETING | SUSPENDED | REQUEUED | RESIZING) echo running ;;
  COMPLETED | "") echo success ;;
  *) echo failed ;;
esac
