//! What the desk does of what a page asks.

use host_sim::scenes;
use host_sim::shot::{Approach, Number, Shot};
use scanray_playground::answer::Answer;
use scanray_playground::desk::Desk;
use serde_json::{Value, json};

const SIZE: [u32; 2] = [24, 18];

fn look(number: &str) -> Value {
    json!({ "number": number, "approach": "trace", "panel": "rgb565", "size": SIZE, "depth": 2, "quality": "exact", "side": 1,
        "dither": "ordered" })
}

/// Asks the desk and answers what it says, as a page reads it.
fn ask(desk: &mut Desk, request: Value) -> Value {
    serde_json::to_value(desk.ask(request.to_string().as_bytes())).unwrap()
}

/// Asks for what there is a fault in and answers what it says.
fn fault(desk: &mut Desk, request: Value) -> String {
    let told = ask(desk, request);
    told["fault"].as_str().unwrap_or_else(|| panic!("no fault: {told}")).to_owned()
}

fn opened(name: &str) -> Desk {
    let mut desk = Desk::default();
    assert_eq!(ask(&mut desk, json!({ "ask": "open", "name": name }))["opened"]["name"], name);
    desk
}

fn frame(desk: &mut Desk, look: Value) -> Vec<u8> {
    let told = ask(desk, json!({ "ask": "frame", "look": look }));
    assert!(told["frame"].is_object(), "{told}");
    desk.pixels().to_vec()
}

#[test]
fn every_scene_is_drawn_as_the_host_draws_it() {
    for scene in scenes::all() {
        let mut desk = opened(scene.name());
        for number in Number::ALL {
            let dither = scanray::Dither::Ordered;
            let shot = Shot { number, size: SIZE, depth: 2, dither, ..Shot::new(scene) };
            let host = shot.take(|_| ()).unwrap().picture.pixels;
            let host: Vec<u8> = host.iter().flat_map(|[r, g, b]| [*r, *g, *b, 255]).collect();
            assert!(frame(&mut desk, look(number.name())) == host, "{} {}", scene.name(), number.name());
        }
    }
}

#[test]
fn what_the_z_buffer_draws_is_the_hosts_and_what_it_does_not_is_refused_as_there() {
    let mut drawn = 0;
    for scene in scenes::all() {
        let mut desk = opened(scene.name());
        let dither = scanray::Dither::Ordered;
        let shot = Shot { size: SIZE, dither, approach: Approach::Raster, ..Shot::new(scene) };
        let mut look = look("f32");
        look["approach"] = json!("raster");
        match shot.take(|_| ()) {
            Ok(taken) => {
                let told = ask(&mut desk, json!({ "ask": "frame", "look": look }));
                assert_eq!(told["frame"]["fragments"].as_u64(), taken.fragments);
                let host = taken.picture.pixels.iter().flat_map(|[r, g, b]| [*r, *g, *b, 255]);
                assert!(desk.pixels().iter().copied().eq(host), "{}", scene.name());
                drawn += 1;
            }
            Err(refusal) => {
                let said = fault(&mut desk, json!({ "ask": "frame", "look": look }));
                assert_eq!(said, format!("the picture cannot be drawn: {refusal}"));
            }
        }
    }
    assert!(drawn > 5, "{drawn}");
}

#[test]
fn rays_are_counted_of_the_cores_tracer_alone() {
    let mut desk = opened("simple");
    let mut raster = look("f32");
    raster["approach"] = json!("raster");
    for look in [look("oracle"), raster] {
        let told = ask(&mut desk, json!({ "ask": "frame", "look": look }));
        assert!(told["frame"]["rays"].is_null(), "{told}");
        let said = fault(&mut desk, json!({ "ask": "heat", "look": look }));
        assert_eq!(said, "rays are counted where the core traces them");
    }
    let told = ask(&mut desk, json!({ "ask": "frame", "look": look("exact") }));
    assert!(told["frame"]["rays"][0].as_u64() > Some(0), "{told}");
}

#[test]
fn the_text_of_every_scene_is_read_again_with_its_files_and_draws_the_same() {
    for scene in scenes::all() {
        let mut desk = opened(scene.name());
        let before = frame(&mut desk, look("fixed"));
        let text = ask(&mut desk, json!({ "ask": "text" }))["text"].clone();
        let told = ask(&mut desk, json!({ "ask": "write", "text": text, "of": scene.name() }));
        assert_eq!(told["opened"]["name"], scene.name(), "{told}");
        assert!(frame(&mut desk, look("fixed")) == before, "{}", scene.name());
    }
}

#[test]
fn a_scene_that_names_an_image_of_no_known_scene_is_refused_by_its_name() {
    let mut desk = opened("textured");
    let text = ask(&mut desk, json!({ "ask": "text" }))["text"].clone();
    let said = fault(&mut desk, json!({ "ask": "write", "text": text, "of": null }));
    assert!(said.starts_with("cannot read the image textured-"), "{said}");
}

#[test]
fn a_mistake_is_told_with_its_line_and_the_scene_before_stays() {
    let mut desk = opened("simple");
    let before = frame(&mut desk, look("f32"));
    let text = ask(&mut desk, json!({ "ask": "text" }))["text"].as_str().unwrap().to_owned();
    let wrong = [
        (text.replace("radius:", "radios:"), "did you mean `radius`?"),
        (text.replace("about:", "about"), "simple.ron:"),
        (text.replacen("radius: ", "radius: -", 1), "its radius is not above zero"),
        (String::new(), "simple.ron"),
    ];
    for (text, says) in wrong {
        let said = fault(&mut desk, json!({ "ask": "write", "text": text, "of": "simple" }));
        assert!(said.contains(says), "{said}");
        assert!(frame(&mut desk, look("f32")) == before);
    }
}

#[test]
fn what_there_is_not_is_refused_in_words() {
    let mut desk = Desk::default();
    assert_eq!(fault(&mut desk, json!({ "ask": "text" })), "no scene was opened");
    assert_eq!(fault(&mut desk, json!({ "ask": "open", "name": "nowhere" })), "there is no scene `nowhere`");
    assert!(fault(&mut desk, json!({ "ask": "nothing" })).starts_with("this is no request: "));
    let Answer::Fault(said) = desk.ask(b"{") else { panic!() };
    assert!(said.starts_with("this is no request: "), "{said}");
    let mut desk = opened("simple");
    let with = |field: &str, value: Value| {
        let mut look = look("f32");
        look[field] = value;
        json!({ "ask": "frame", "look": look })
    };
    let wrong = [
        ("number", json!("f16"), "there is no number `f16`"),
        ("approach", json!("radiosity"), "there is no approach `radiosity`"),
        ("panel", json!("rgb333"), "there is no panel `rgb333`"),
        ("dither", json!("loud"), "there is no dither `loud`"),
        ("quality", json!("best"), "there is no quality `best`"),
        ("size", json!([0, 5]), "a picture has 1 to 1024 pixels along each side"),
        ("size", json!([5, 4_000_000_000_u32]), "a picture has 1 to 1024 pixels along each side"),
        ("depth", json!(200), "there are at most 32 mirrors"),
    ];
    for (field, value, says) in wrong {
        assert_eq!(fault(&mut desk, with(field, value)), says);
    }
    let mut sampled = look("f32");
    (sampled["quality"], sampled["side"]) = (json!("uniform"), json!(0));
    assert!(
        fault(&mut desk, json!({ "ask": "frame", "look": sampled })).contains("rays along a side of a pixel")
    );
    assert_eq!(fault(&mut desk, json!({ "ask": "pixel", "at": [1, 1] })), "the picture has no pixel 1, 1");
    frame(&mut desk, look("f32"));
    assert_eq!(fault(&mut desk, json!({ "ask": "pixel", "at": [24, 0] })), "the picture has no pixel 24, 0");
}

#[test]
fn every_choice_that_is_offered_is_taken() {
    let mut desk = opened("displaced");
    let choices = ask(&mut desk, json!({ "ask": "choices" }))["choices"].clone();
    // Numbers differ in few pixels: of craters, in 8 bits a channel, by a step.
    let fine = |field: &str, word: Value| {
        let mut look = look("f32");
        (look["panel"], look["side"], look["size"]) = (json!("rgb888"), json!(2), json!([96, 72]));
        look[field] = word;
        look
    };
    let usual = frame(&mut desk, fine("number", json!("f32")));
    let fields =
        [("number", "numbers"), ("panel", "panels"), ("quality", "qualities"), ("dither", "dithers")];
    for (field, all) in fields {
        let words = choices[all].as_array().unwrap();
        assert!(words.len() > 1, "{all}");
        let pictures = words.iter().map(|word| frame(&mut desk, fine(field, word.clone())));
        assert!(pictures.filter(|picture| *picture != usual).count() > 0, "{all}");
    }
}

#[test]
fn a_pixel_a_heat_map_and_source_are_told_of_the_open_scene() {
    let mut desk = opened("three-spheres");
    let pixels = frame(&mut desk, look("fixed"));
    let told = ask(&mut desk, json!({ "ask": "pixel", "at": [12, 9] }))["pixel"].clone();
    let place = 4 * (9 * SIZE[0] + 12) as usize;
    assert_eq!(told["shown"], json!(pixels[place..place + 3]));
    assert_eq!(told["bits"].as_str().map(str::len), Some("00000 000000 00000".len()));
    let heat = ask(&mut desk, json!({ "ask": "heat", "look": look("fixed") }))["heat"].clone();
    assert!(heat["range"][0].as_u64() < heat["range"][1].as_u64(), "{heat}");
    assert_ne!(desk.pixels(), pixels);
    let source = ask(&mut desk, json!({ "ask": "source", "number": "fixed" }))["text"].clone();
    assert!(source.as_str().is_some_and(|text| text.contains("pub static SCENE")), "{source}");
}
