//! The experiments and extreme cases of the laboratory.

testing::check_lab! { a06_lab::laboratory() }
