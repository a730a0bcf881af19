//! Bytes of an OpenSim model in; contacts, plan and patched bytes out.
