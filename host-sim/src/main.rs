//! x
use scanray::gallery::*;
use scanray::math::Scalar;
use host_sim::{panel::Panel, picture::trace};
fn dump<S: Gallery>(tag: &str) {
    for v in S::views() {
        let f = trace(v, v.settings, v.size, |_| ()).unwrap();
        let p = f.on_panel(Panel::Rgb888, v.settings.transfer, v.settings.dither);
        let mut o = format!("P6 {} {} 255\n", v.size[0], v.size[1]).into_bytes();
        o.extend(p.iter().flatten());
        std::fs::write(format!("/tmp/out/{}-{tag}.ppm", v.name), o).unwrap();
        println!("{} {tag} {:?}", v.name, f.rays);
    }
}
fn main() { std::fs::create_dir_all("/tmp/out").unwrap(); dump::<f32>("f32"); dump::<scanray::Fixed>("fixed"); dump::<f64>("exact"); let _ = <f32 as Scalar>::ONE; }
