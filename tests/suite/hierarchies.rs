//! Hierarchies whose links lead astray are refused, and sound ones say what they hold.

use scanray::accel::{Bvh, BvhNode, Every, Grid, Hierarchy, Kd, KdNode, Lattice, Lists, Octant, Octree};
use scanray::ray::{Interval, Ray};
use scanray::trace::{Candidates, Packet, Tracer};
use scanray::{Fault, Material, Object, Rgb, Scalar, Scene, Shape, Sphere, Vec3};

const CUBE: Lattice = Lattice::new(Vec3::new(-1.0, -1.0, -1.0), 2.0);
const WHOLE: [[u16; 3]; 2] = [[0; 3], [65_535; 3]];

/// Names nothing, then things 0 and 1, then thing 2.
const LISTS: Lists = Lists::new(&[0, 0, 2, 3], &[0, 1, 2]);

const NODES: [KdNode; 5] = [
    KdNode::Split { axis: 0, at: 30_000, children: 1 },
    KdNode::Leaf { list: 1 },
    KdNode::Split { axis: 2, at: 40_000, children: 3 },
    KdNode::Leaf { list: 0 },
    KdNode::Leaf { list: 2 },
];

const fn kd(nodes: &'static [KdNode], lists: Lists) -> Kd {
    Kd { lattice: CUBE, bounds: WHOLE, nodes, count: 3, lists }
}

const BRANCHES: [[Octant; 8]; 2] = [
    [
        Octant::leaf(0),
        Octant::leaf(0),
        Octant::branch(1),
        Octant::leaf(1),
        Octant::leaf(0),
        Octant::leaf(0),
        Octant::leaf(0),
        Octant::leaf(2),
    ],
    [Octant::leaf(2); 8],
];

const fn octree(branches: &'static [[Octant; 8]], lists: Lists) -> Octree {
    Octree { lattice: CUBE, bounds: WHOLE, branches, count: 3, lists }
}

const GRID: Grid = Grid {
    lattice: CUBE,
    low: [0; 3],
    size: 30_000,
    cells: [3, 2, 1],
    content: &[0, 1, 0, 2, 2, 0],
    count: 3,
    lists: LISTS,
};

/// Answers what a ray along x may meet, in order.
fn met(hierarchy: &dyn Hierarchy<f32>) -> Vec<u16> {
    let ray = Ray::new(Vec3::new(-5.0, 0.1, -0.5), Vec3::new(1.0, 0.0, 0.0));
    let mut met = vec![];
    hierarchy.walk(&ray, &Interval::AHEAD, &mut |number| {
        met.push(number);
        f32::FAR
    });
    met
}

#[track_caller]
fn assert_refused(hierarchy: &dyn Hierarchy<f32>) {
    assert_eq!(hierarchy.check(), Err(Fault::Hierarchy), "{hierarchy:?}");
}

#[test]
fn sound_ones_are_taken_and_walked_front_to_back() {
    let (kd, octree) = (kd(&NODES, LISTS), octree(&BRANCHES, LISTS));
    for hierarchy in [&kd as &dyn Hierarchy<f32>, &octree, &GRID, &Every(3)] {
        assert_eq!((hierarchy.check(), hierarchy.count()), (Ok(()), 3), "{hierarchy:?}");
    }
    // The ray goes along x in the upper half of y and the lower one of z.
    assert_eq!(met(&kd), [0, 1]);
    assert_eq!(met(&octree), [2, 2, 0, 1]);
    assert_eq!(met(&GRID), [2, 2]);
}

#[test]
fn a_ray_looks_no_farther_than_the_nearest_thing_so_far() {
    let nodes = [NODES[0], NODES[1], KdNode::Leaf { list: 2 }];
    let kd = kd(Vec::from(nodes).leak(), LISTS);
    let ray = Ray::new(Vec3::new(-5.0, 0.1, 0.1), Vec3::new(1.0, 0.0, 0.0));
    for (far, expected) in [(f32::FAR, 3), (4.5, 2), (0.0, 1)] {
        let mut count = 0;
        kd.walk(&ray, &Interval::AHEAD, &mut |_| {
            count += 1;
            far
        });
        assert_eq!(count, expected, "things are met at {far}");
    }
}

#[test]
fn of_two_things_at_the_same_place_the_one_listed_first_is_seen_in_whichever_order_they_are_named() {
    let ball: Shape = Shape::Sphere(Sphere::new(Vec3::ZERO, 0.5));
    let objects = [Object::new(ball, 0), Object::new(ball, 1)];
    let materials = [Material::flat(Rgb::WHITE), Material::flat(Rgb::BLACK)];
    let ray = Ray::new(Vec3::new(-5.0, 0.1, 0.1), Vec3::new(1.0, 0.0, 0.0));
    for items in [&[0, 1], &[1, 0]] {
        let lists = Lists::new(&[0, 2], items);
        let tree = Kd { lattice: CUBE, bounds: WHOLE, nodes: &[KdNode::Leaf { list: 0 }], count: 2, lists };
        let scene = Scene::new(&objects, &materials, &[]).with_hierarchy(&tree);
        let mut packet = Packet::new();
        let light = Tracer::new(&scene, &mut []).radiance(
            &mut packet,
            std::iter::once((ray, Interval::AHEAD)),
            Candidates::all(&scene),
            &mut (),
        );
        assert_eq!(light[0], Rgb::WHITE, "named as {items:?}");
    }
}

#[test]
fn a_kd_tree_whose_links_do_not_make_a_tree_is_refused() {
    let split = |children| KdNode::Split { axis: 0, at: 9, children };
    let leaf = |list| KdNode::Leaf { list };
    let wrong: [&[KdNode]; 7] = [
        &[split(0), leaf(0), leaf(0)],
        &[split(2), leaf(0), leaf(0)],
        &[split(1), leaf(0)],
        &[split(1), leaf(0), leaf(3)],
        &[split(1), leaf(0), leaf(0), leaf(0)],
        &[leaf(0), split(1), leaf(0)],
        &[KdNode::Split { axis: 3, at: 9, children: 1 }, leaf(0), leaf(0)],
    ];
    for nodes in wrong {
        assert_refused(&kd(Vec::from(nodes).leak(), LISTS));
    }
    assert_eq!(kd(&[], Lists::new(&[], &[])).check(), Ok(()));
}

#[test]
fn a_kd_tree_deeper_than_a_walk_remembers_is_refused() {
    let deep = |splits: u16| {
        let levels = (0..splits).flat_map(|level| {
            [KdNode::Leaf { list: 0 }, KdNode::Split { axis: 1, at: 9, children: 2 * level + 1 }]
        });
        let ends = [KdNode::Leaf { list: 0 }; 2];
        kd(levels.skip(1).chain(ends).collect::<Vec<_>>().leak(), LISTS)
    };
    assert_eq!(deep(32).check(), Ok(()));
    assert_refused(&deep(33));
}

#[test]
fn an_octree_whose_links_do_not_make_a_tree_is_refused() {
    let with = |place: usize, octant: Octant| {
        let mut branches = BRANCHES;
        branches[1][place] = octant;
        octree(Vec::from(branches).leak(), LISTS)
    };
    assert_eq!(with(3, Octant::leaf(2)).check(), Ok(()));
    for wrong in [Octant::branch(0), Octant::branch(1), Octant::branch(2), Octant::branch(3), Octant::leaf(3)]
    {
        assert_refused(&with(3, wrong));
    }
    // A branch that nothing names.
    assert_refused(&octree(&const { [[Octant::leaf(0); 8]; 2] }, LISTS));
}

#[test]
fn an_octree_finer_than_its_steps_is_refused() {
    let deep = |levels: u16| {
        let branches = (1..=levels).map(|next| {
            let mut octants = [Octant::leaf(0); 8];
            octants[5] = if next < levels { Octant::branch(next) } else { Octant::leaf(1) };
            octants
        });
        octree(branches.collect::<Vec<_>>().leak(), LISTS)
    };
    assert_eq!(deep(16).check(), Ok(()));
    assert_refused(&deep(17));
}

#[test]
fn a_grid_whose_cells_are_not_listed_is_refused() {
    assert_refused(&Grid { cells: [3, 2, 2], ..GRID });
    assert_refused(&Grid { cells: [3, 2, 0], ..GRID });
    assert_refused(&Grid { size: 0, ..GRID });
    assert_refused(&Grid { content: &[0, 1, 0, 2, 3, 0], ..GRID });
    // The last of three cells would begin beyond the cube.
    assert_refused(&Grid { low: [5_536, 0, 0], ..GRID });
    assert_eq!(Grid { low: [5_535, 0, 0], ..GRID }.check(), Ok(()));
}

#[test]
fn lists_that_name_what_there_is_not_are_refused() {
    let wrong = [
        Lists::new(&[0, 0, 2, 3], &[0, 1, 3]),
        Lists::new(&[0, 0, 2, 2], &[0, 1, 2]),
        Lists::new(&[0, 0, 2, 4], &[0, 1, 2]),
        Lists::new(&[1, 1, 2, 3], &[0, 1, 2]),
        Lists::new(&[0, 3, 2, 3], &[0, 1, 2]),
        Lists::new(&[], &[0]),
    ];
    for lists in wrong {
        assert_refused(&kd(&NODES, lists));
        assert_refused(&octree(&BRANCHES, lists));
        assert_refused(&Grid { lists, ..GRID });
    }
}

#[test]
fn a_bvh_whose_links_do_not_make_a_tree_is_refused() {
    let leaf = |link, parent| BvhNode::new(WHOLE, link, parent, 1, 0);
    let bvh = |nodes: &[BvhNode]| Bvh { lattice: CUBE, nodes: Vec::from(nodes).leak(), count: 2, items: &[] };
    let root = BvhNode::new(WHOLE, 1, 0, 0, 0);
    assert_eq!(bvh(&[root, leaf(0, 0), leaf(1, 0)]).check(), Ok(()));
    assert_refused(&bvh(&[root, leaf(0, 0), leaf(2, 0)]));
    assert_refused(&bvh(&[root, leaf(0, 0), leaf(1, 1)]));
    assert_refused(&bvh(&[root, leaf(0, 0)]));
    assert_refused(&bvh(&[BvhNode::new(WHOLE, 0, 0, 0, 0), leaf(0, 0), leaf(1, 0)]));
}

#[test]
fn a_bvh_of_as_many_nodes_as_there_may_be_is_taken() {
    let nodes = (0..65_535_u32).map(|number| {
        let parent = (number.saturating_sub(1) / 2) as u16;
        if number < 32_767 {
            BvhNode::new(WHOLE, (2 * number + 1) as u16, parent, 0, 0)
        } else {
            BvhNode::new(WHOLE, (number - 32_767) as u16, parent, 1, 0)
        }
    });
    let nodes: &'static [BvhNode] = nodes.collect::<Vec<_>>().leak();
    assert_eq!(Bvh { lattice: CUBE, nodes, count: 32_768, items: &[] }.check(), Ok(()));
    assert_refused(&Bvh { lattice: CUBE, nodes, count: 32_767, items: &[] });
}

#[test]
fn nodes_are_as_small_as_they_say() {
    assert_eq!([size_of::<BvhNode>(), size_of::<KdNode>(), size_of::<Octant>()], [18, 6, 2]);
}
