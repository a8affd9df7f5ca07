//! In random scenes, the light at places of a pixel differs by no more than its contrast.

use common::{Color, Settings, Size};
use glam::{DMat4, DVec3, dvec3};

use crate::adaptive::PixelRandom;
use crate::{
    AxisAlignedBox, Basis, Camera, Disc, Light, LightKind, Phong, Plane, Renderer, Scene, Shading,
    Shape, Sphere, Surface, Transform, Triangle,
};

const SCENES: u32 = 600;

/// Random numbers, one after the other.
struct Numbers {
    random: PixelRandom,
    next: u64,
}

impl Numbers {
    fn between(&mut self, least: f64, most: f64) -> f64 {
        self.next += 1;
        least + (most - least) * self.random.uniform(self.next - 1)
    }

    /// One of the whole numbers below this.
    fn below(&mut self, count: u32) -> u32 {
        self.between(0.0, f64::from(count)) as u32
    }

    fn point(&mut self, half: f64) -> DVec3 {
        let [x, y, z] = [(); 3].map(|()| self.between(-half, half));
        dvec3(x, y, z)
    }

    fn unit(&mut self) -> DVec3 {
        self.point(1.0).normalize()
    }

    fn color(&mut self) -> Color {
        let [r, g, b] = [(); 3].map(|()| self.between(0.0, 1.0));
        Color::new(r, g, b)
    }

    fn basis(&mut self) -> Basis {
        let w = (DVec3::Z + self.point(0.3)).normalize();
        let u = self.unit().cross(w).normalize();
        let e = dvec3(0.0, 0.0, 6.0) + self.point(1.0);
        Basis {
            e,
            u,
            v: w.cross(u),
            w,
        }
    }

    fn camera(&mut self) -> Camera<'static> {
        let basis = self.basis();
        if self.below(3) == 0 {
            let scale = self.between(0.1, 8.0);
            return Camera::Orthographic { basis, scale };
        }
        let half_tangent = libm::exp(self.between(-3.0, 1.0));
        Camera::Perspective {
            basis,
            half_tangent,
        }
    }

    /// Some are larger than the picture, others smaller than a pixel.
    fn shape(&mut self) -> Shape<'static> {
        let (point, normal) = (self.point(3.0), self.unit());
        let radius = libm::exp(self.between(-4.0, 3.0));
        let plane = Plane { point, normal };
        match self.below(6) {
            0 => Shape::Plane(plane),
            1 => Shape::Disc(Disc { plane, radius }),
            2 => Shape::Box(AxisAlignedBox {
                min: (point - radius).to_array(),
                max: (point + radius * self.between(0.1, 1.0)).to_array(),
            }),
            3 => {
                let corners = [(); 3].map(|()| point + self.point(2.0 * radius));
                let [a, b, c] = corners;
                let doubled_area = (b - a).cross(c - a);
                let geometric_normal = doubled_area.normalize();
                let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
                let mut normals = [geometric_normal; 3];
                if self.below(2) == 0 {
                    normals[2] = (geometric_normal + self.point(0.3)).normalize();
                }
                Shape::Triangle(Triangle {
                    corners,
                    normals,
                    geometric_normal,
                    // The least height is the doubled area divided by the longest edge.
                    scale: longest * longest * longest / doubled_area.length(),
                })
            }
            _ => Shape::Sphere(Sphere {
                center: point,
                radius,
            }),
        }
    }

    fn light(&mut self) -> Light<'static> {
        let color = self.color();
        let (position, direction) = (self.point(6.0), self.unit());
        let kind = match self.below(3) {
            0 => LightKind::Directional { color, direction },
            1 => LightKind::Point { color, position },
            _ => LightKind::Spot {
                color,
                position,
                direction: (self.point(1.0) - position).normalize(),
                cos_half_angle: self.between(0.5, 1.0),
            },
        };
        Light {
            kind,
            casts_shadows: self.below(3) == 0,
        }
    }

    fn surface(&mut self) -> Surface<'static> {
        let shading = if self.below(6) == 0 {
            Shading::SingleColor(self.color())
        } else {
            Shading::Phong(Phong {
                diffuse: self.color(),
                specular: if self.below(2) == 0 {
                    Color::BLACK
                } else {
                    self.color()
                },
                exponent: if self.below(4) == 0 {
                    self.between(0.0, 1.0)
                } else {
                    libm::exp(self.between(0.0, 7.0))
                },
            })
        };
        let is_mirror = self.below(4) == 0;
        let reflection = if is_mirror {
            self.color()
        } else {
            Color::BLACK
        };
        Surface {
            shading,
            reflection,
        }
    }

    fn scene(&mut self) -> Scene<'static> {
        let depth = 1 + self.below(3);
        let mut scene = Scene::new(self.color(), self.color(), depth);
        for _ in 0..=self.below(4) {
            let surface = scene.add_surface(self.surface());
            let mut shape = self.shape();
            if self.below(4) == 0 {
                let matrix = DMat4::from_translation(self.point(1.0))
                    * DMat4::from_axis_angle(self.unit(), self.between(0.0, 3.0))
                    * DMat4::from_scale(dvec3(1.0, self.between(0.5, 2.0), 1.5));
                shape = shape.transformed(&Transform {
                    matrix,
                    inverse: matrix.inverse(),
                });
            }
            scene.add_shape(shape, surface);
        }
        for _ in 0..=self.below(2) {
            scene.add_light(self.light());
        }
        scene
    }
}

/// Each pixel of a known contrast gets samples near its corners and inside.
#[test]
fn the_light_of_a_pixel_differs_by_no_more_than_its_contrast() {
    let size = Size::new(11, 8).unwrap();
    let settings = Settings {
        size,
        ..Settings::default()
    };
    // Pixels of a known contrast, those among them whose light changes, and the largest part of
    // the contrast by which it does.
    let (mut known, mut changing, mut largest) = (0, 0, 0.0_f64);
    for i in 0..SCENES {
        let mut numbers = Numbers {
            random: PixelRandom::new(45, i, 0),
            next: 0,
        };
        let (scene, camera) = (numbers.scene(), numbers.camera());
        let contrasts = scene.contrasts(&camera, size);
        let renderer = Renderer::new(scene, camera, &settings);
        for (at, contrast) in contrasts.iter().enumerate() {
            let contrast = f64::from(*contrast);
            if !contrast.is_finite() {
                continue;
            }
            known += 1;
            let column = (at % 11) as f64;
            let row = (7 - at / 11) as f64;
            let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
            for sample in 0..16 {
                let half = if sample < 4 {
                    0.499
                } else {
                    numbers.between(0.0, 0.5)
                };
                let dx = if sample & 1 == 0 { half } else { -half };
                let half = if sample < 4 {
                    0.499
                } else {
                    numbers.between(0.0, 0.5)
                };
                let dy = if sample & 2 == 0 { half } else { -half };
                let light = renderer
                    .light_at(&settings, (column + dx, row + dy))
                    .channels();
                for channel in 0..3 {
                    least[channel] = least[channel].min(light[channel]);
                    most[channel] = most[channel].max(light[channel]);
                }
            }
            let differences = (0..3).map(|channel| most[channel] - least[channel]);
            let difference = differences.fold(0.0, f64::max);
            assert!(
                difference <= contrast + 1e-9,
                "scene {i}, pixel {at}: {difference} above {contrast}"
            );
            if difference > 1e-9 {
                changing += 1;
                largest = largest.max(difference / contrast);
            }
        }
    }
    // The bounds are met in many pixels, and nearly reached in one.
    assert!(known > 5_000 && changing > 500, "{known}, {changing}");
    assert!(largest > 0.5, "{largest}");
}

/// A scene of this shape, matt in the light of one lamp that casts shadows.
fn lit(shapes: impl IntoIterator<Item = Shape<'static>>) -> Scene<'static> {
    let mut scene = Scene::new(Color::gray(0.25), Color::BLACK, 2);
    let surface = scene.add_surface(Surface::matt(Shading::Phong(Phong {
        diffuse: Color::gray(0.5),
        specular: Color::BLACK,
        exponent: 1.0,
    })));
    for shape in shapes {
        scene.add_shape(shape, surface);
    }
    scene.add_light(Light {
        kind: LightKind::Point {
            color: Color::WHITE,
            position: dvec3(0.0, 0.0, 4.0),
        },
        casts_shadows: true,
    });
    scene
}

/// Twenty pixels, each a unit wide, before the plane `z = 0` and seen from `z = 10`.
fn from_above() -> (Camera<'static>, Size) {
    let (u, v, w) = (DVec3::X, DVec3::Y, DVec3::Z);
    let basis = Basis {
        e: dvec3(0.0, 0.0, 10.0),
        u,
        v,
        w,
    };
    let scale = 3.0;
    (
        Camera::Orthographic { basis, scale },
        Size::new(5, 4).unwrap(),
    )
}

/// The pixels are 5/4 x 3 / 4 wide, and 3 / 3 high.
#[test]
fn the_bounds_of_a_box_cover_its_pixels_only() {
    let (camera, size) = from_above();
    let cube = AxisAlignedBox {
        min: [-1.0, -0.9, -1.0],
        max: [-0.1, -0.1, 1.0],
    };
    let contrasts = lit([Shape::Box(cube)]).contrasts(&camera, size);
    let covered = |at: &usize| contrasts[*at] > 0.0;
    // Columns are counted from the left, where x is -2.34; rows from above, where y is 2.
    let covered: Vec<_> = (0..20).filter(covered).collect();
    assert_eq!(covered, [11, 12]);
}

/// In a pixel of the diagonal `√(0.9375² + 1)` the lamp above turns by less than that divided by
/// its distance, 4, less the diagonal.
#[test]
fn a_lone_plane_has_a_small_contrast_and_another_shape_may_throw_a_shadow_on_it() {
    let (camera, size) = from_above();
    let plane = || {
        Shape::Plane(Plane {
            point: DVec3::ZERO,
            normal: DVec3::Z,
        })
    };
    let diagonal = libm::hypot(0.9375, 1.0);
    for contrast in lit([plane()]).contrasts(&camera, size) {
        let turn = diagonal / (4.0 - diagonal);
        assert!(
            contrast > 0.0 && f64::from(contrast) <= 0.5 * turn * 1.000_001,
            "{contrast}"
        );
    }
    let speck = Sphere {
        center: dvec3(0.0, 0.0, 2.0),
        radius: 1e-3,
    };
    let contrasts = lit([plane(), Shape::Sphere(speck)]).contrasts(&camera, size);
    assert!(contrasts.iter().all(|contrast| *contrast >= 0.5));
}

#[test]
fn nothing_is_known_of_shapes_and_cameras_that_are_functions() {
    let (camera, size) = from_above();
    assert!(
        lit([Shape::other(|_| None)])
            .contrasts(&camera, size)
            .is_empty()
    );
    let ray = |_, x, y| crate::Ray {
        origin: dvec3(x, y, 0.0),
        direction: DVec3::Z,
    };
    let sphere = Shape::Sphere(Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    });
    let camera = Camera::Other(Box::new(ray));
    assert!(lit([sphere]).contrasts(&camera, size).is_empty());
}
