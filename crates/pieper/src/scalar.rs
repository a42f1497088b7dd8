//! The number types a kernel accepts.
