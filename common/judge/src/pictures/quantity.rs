//! `Quantity`: what a fact measures in pictures.

use crate::pictures::fitted_slope::Axis;
use crate::pictures::line::Line;
use crate::pictures::run::Run;
use crate::pictures::theory::Theory;
use crate::pictures::values::Region;

/// What is measured.
#[derive(Debug)]
pub enum Quantity {
    Mean(Region),
    Greatest(Region),
    Least(Region),
    /// The share of pixels that have the value of the pixel below.
    Alike(Region),
    /// The greatest correlation between pixels and others at the same distance from each.
    Autocorrelation(Region),
    /// The greatest share of one value, where a pixel weighs as much as its row, counted from below.
    Load(Region),
    /// The place of an edge on a line, in pixels from its beginning.
    Edge(Line),
    /// Pixels between 10 % and 90 % of an edge on a line.
    Width(Line),
    /// The root mean square difference from what is exact.
    Spread {
        region: Region,
        exact: Exact,
    },
    /// The number of pixels whose bytes differ from those of another picture.
    Same(Run),
    /// The greatest difference between the steps of the means from one picture to the next.
    Growth {
        region: Region,
        runs: Vec<Run>,
    },
    /// The slope of log spread over samples or their logarithm.
    Slope {
        region: Region,
        exact: Exact,
        axis: Axis,
        runs: Vec<Run>,
        theory: Option<Theory>,
    },
}

impl Quantity {
    /// Whether a picture of one colour can have no such value: it has no edge and no noise, its error does not fall,
    /// and one thread has drawn all of it.
    pub const fn needs_two_colors(&self) -> bool {
        matches!(
            self,
            Self::Autocorrelation(_)
                | Self::Load(_)
                | Self::Edge(_)
                | Self::Width(_)
                | Self::Slope { .. }
        )
    }

    /// The region that is measured; none of a line and of whole pictures.
    pub const fn region(&self) -> Option<Region> {
        match self {
            Self::Mean(region)
            | Self::Greatest(region)
            | Self::Least(region)
            | Self::Alike(region)
            | Self::Autocorrelation(region)
            | Self::Load(region)
            | Self::Spread { region, .. }
            | Self::Growth { region, .. }
            | Self::Slope { region, .. } => Some(*region),
            Self::Edge(_) | Self::Width(_) | Self::Same(_) => None,
        }
    }
}

/// What a spread is the distance from.
#[derive(Debug)]
pub enum Exact {
    Number(f64),
    /// A number for each column of the region.
    Columns(Vec<f64>),
    /// The picture of another run.
    Run(Run),
}
