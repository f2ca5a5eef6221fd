//! The list of exact versions that a project is built with, `Cargo.lock`.

/// Is what a package begins with.
const PACKAGE: &str = "[[package]]\n";

/// Answers whether a package of that name is listed.
pub fn lists(lock: &str, name: &str) -> bool {
    lock.lines().any(|line| line == format!("name = \"{name}\""))
}

/// Answers the list with the packages in the order of their names, as cargo keeps it: a project that got another name
/// moves to its place.
pub fn sorted(lock: &str) -> String {
    let mut parts = lock.split(PACKAGE);
    let head = parts.next().unwrap_or_default();
    let mut packages: Vec<_> = parts.map(str::trim_end).collect();
    // Versions of one package keep their order.
    packages.sort_by_key(|package| package.lines().next());
    let packages: Vec<_> = packages.iter().map(|package| format!("{PACKAGE}{package}\n")).collect();
    head.to_owned() + &packages.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn package(name: &str, version: u8) -> String {
        format!("{PACKAGE}name = \"{name}\"\nversion = \"{version}\"\n")
    }

    fn lock(packages: [(&str, u8); 4]) -> String {
        format!("version = 4\n\n{}", packages.map(|(name, version)| package(name, version)).join("\n"))
    }

    #[test]
    fn a_renamed_package_moves_to_its_place_and_versions_of_one_stay_in_order() {
        let renamed = lock([("bitflags", 1), ("bitflags", 2), ("az", 3), ("cortex-m", 4)]);
        assert_eq!(sorted(&renamed), lock([("az", 3), ("bitflags", 1), ("bitflags", 2), ("cortex-m", 4)]));
        assert!(lists(&renamed, "bitflags") && !lists(&renamed, "bit") && !lists(&renamed, "flags"));
    }
}
