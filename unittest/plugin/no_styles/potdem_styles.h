/* in place of src/styles/potdem_styles.h: a LAMMPS without them */
