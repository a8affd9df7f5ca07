//! A smooth triangle and a ball that lean, compared with the solution.

use crate::prelude::*;

yours! {
    Sheared => new_shape(|(upright, by): (crate::sheared::Upright, f64)| {
        Ok(Sheared::new(upright.shape()?, by))
    })
}

/// A shape that does not lean yet.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Upright {
    /// A ball around the origin.
    Ball,
    /// A triangle whose corners have normals aslant.
    Triangle,
    /// A beam of the picture.
    Beam,
    /// A ball of the picture.
    BallOnFloor,
}

impl Upright {
    pub fn shape(self) -> Made<Shape> {
        Ok(match self {
            Self::Ball => Box::new(Sphere::new(Point3::ORIGIN, 1.0)?),
            Self::Triangle => Box::new(smooth_triangle(0.0)?),
            Self::Beam => {
                let (lbf, run) = ([-2.3, 0.0, -0.7], [-1.0, 2.0, 0.7]);
                Box::new(AxisAlignedBox::new(point(lbf), point(run))?)
            }
            Self::BallOnFloor => Box::new(Sphere::new(Point3::new(0.9, 1.0, 0.0), 1.0)?),
        })
    }
}

impl Input for Upright {
    fn for_each_number(&mut self, _: &mut dyn FnMut(&mut f64)) {}

    fn words(&self) -> Vec<String> {
        let words = if *self == Self::Ball {
            "a ball"
        } else {
            "a triangle"
        };
        vec![words.to_owned()]
    }
}

/// Makes a shape that leans by this much.
type Code = NewShape<(Upright, f64)>;

pub fn exercise() -> Exercise<Code> {
    let eye = Eye {
        from: [0.3, 2.6, 7.5],
        to: [0.3, 0.8, 0.0],
    };
    Exercise {
        picture: lit(eye, beam_and_ball),
        ..shapes(Shapes {
            words: "{} sheared by {}",
            first: (Upright::Ball, 0.5),
            further: vec![(Upright::Triangle, 0.5)],
            on_surface: vec![[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.5, 1.0, 0.0]],
            own_rays: vec![],
            middle: |_| [0.0; 3],
            any: |r| {
                let upright = [Upright::Ball, Upright::Triangle][r.below(2) as usize];
                (upright, r.between(-3.0, 3.0))
            },
        })
    }
}

fn beam_and_ball(new: &Code) -> Made<World<Color>> {
    let floor = Plane::new(Point3::ORIGIN, Normal3::new(0.0, 1.0, 0.0))?;
    Ok(World::new(Color::gray(0.08))?
        .with(floor, Color::gray(0.6))
        .with(new((Upright::Beam, 0.6))?, Color::new(0.4, 0.7, 1.0))
        .with(new((Upright::BallOnFloor, 0.6))?, Color::new(1.0, 0.5, 0.3)))
}
