//! Functions that a C compiler made, called by their addresses.

use freebody_core::scalar::Block;
use pyo3::prelude::*;
use std::sync::Arc;

type Function = unsafe extern "C" fn(usize, *const f64, *mut f64);

/// A function `void f(size_t n, const double *given, double *out)` of a loaded library, over columns of numbers.
#[derive(Debug)]
struct Loaded {
    function: Function,
    given: usize,
    results: usize,
}

impl Block for Loaded {
    fn call(&self, lanes: usize, given: &[f64], out: &mut [f64]) {
        assert_eq!((given.len(), out.len()), (lanes * self.given, lanes * self.results));
        // SAFETY: the function reads `given` and writes `results` numbers for each of `lanes` columns.
        unsafe { (self.function)(lanes, given.as_ptr(), out.as_mut_ptr()) }
    }
}

/// Compiled derivatives of a model, in its own chart and in quaternions.
#[pyclass(frozen, from_py_object, module = "freebody._core")]
#[derive(Clone)]
pub struct Compiled(pub [Arc<dyn Block>; 2]);

#[pymethods]
impl Compiled {
    /// Of two functions: address, how many numbers it is given, how many it gives.
    ///
    /// Their libraries must stay loaded; Python never unloads one.
    #[new]
    fn new(own: (usize, usize, usize), quaternion: (usize, usize, usize)) -> Self {
        Self([own, quaternion].map(|(address, given, results)| {
            // SAFETY: `freebody.compilation` takes the address from a library that it has built of
            // `Function::print_block`, whose functions have this type.
            let function = unsafe { std::mem::transmute::<usize, Function>(address) };
            Arc::new(Loaded { function, given, results }) as Arc<dyn Block>
        }))
    }
}
