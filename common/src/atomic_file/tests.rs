use super::*;
use std::fs::File;
use std::time::SystemTime;

#[test]
fn files_that_cannot_be_written_are_refused_before() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    for (path, reason) in [
        (folder.path().to_owned(), "a folder has this name"),
        (folder.path().join("missing/a.png"), "create it first"),
        (file.join("a.png"), "is a file, not a folder"),
    ] {
        let error = check_writable(&path).unwrap_err().to_string();
        assert!(error.ends_with(reason), "{error}");
        let same = write(&path, &b"new"[..]);
        assert_eq!(same.unwrap_err().to_string(), error);
    }
    check_writable(&folder.path().join("a.png")).unwrap();
    check_writable(&file).unwrap();
    assert_eq!(folder.path().read_dir().unwrap().count(), 1);
    assert_eq!(fs::read(&file).unwrap(), b"");
}

#[test]
#[cfg(target_os = "linux")]
fn the_error_names_a_folder_without_permission() {
    // Not even the superuser can make a file in /proc.
    let error = check_writable(Path::new("/proc/a.png")).unwrap_err();
    let expected = "cannot write /proc/a.png: no file can be made in /proc (";
    assert!(error.to_string().starts_with(expected), "{error}");
}

#[test]
fn a_read_error_keeps_the_old_file() {
    struct Broken;
    impl Read for Broken {
        fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
            Err(ErrorKind::StorageFull.into())
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.csv");
    fs::write(&path, "old").unwrap();
    let error = write(&path, b"new".chain(Broken)).unwrap_err().to_string();
    assert!(error.contains("no room left; make some"), "{error}");
    assert_eq!(fs::read(&path).unwrap(), b"old");
    assert_eq!(folder.path().read_dir().unwrap().count(), 1);
}

#[test]
fn old_temporary_files_of_killed_programs_are_deleted() {
    let folder = tempfile::tempdir().unwrap();
    let left = |name: &str, age: u64| {
        let path = folder.path().join(name);
        let time = SystemTime::now() - Duration::from_secs(age);
        let file = File::create(&path).unwrap();
        file.set_modified(time).unwrap();
        path
    };
    let old = left(".saving-abc123.part", 3700);
    let kept = [
        left(".saving-def456.part", 3500),
        left(".saving-money", 9999),
        left("mine.part", 9999),
    ];
    write(&folder.path().join("a.csv"), &b"new"[..]).unwrap();
    assert!(!old.exists());
    assert!(kept.iter().all(|path| path.exists()));
}

#[cfg(unix)]
mod links {
    use super::*;
    use std::os::unix::fs::symlink;

    #[test]
    fn a_link_stays_and_its_target_is_written() {
        let folder = tempfile::tempdir().unwrap();
        let (here, there) = (folder.path().join("here"), folder.path().join("there"));
        fs::create_dir(&here).unwrap();
        fs::create_dir(&there).unwrap();
        symlink("second", here.join("first")).unwrap();
        symlink("../there/file", here.join("second")).unwrap();
        for content in ["one", "two"] {
            write(&here.join("first"), content.as_bytes()).unwrap();
            assert_eq!(fs::read(there.join("file")).unwrap(), content.as_bytes());
        }
        assert!(here.join("first").is_symlink() && here.join("second").is_symlink());
        assert!(!there.join("file").is_symlink());
        assert!(!write_new(&here.join("first"), &b"three"[..]).unwrap());
        assert_eq!(there.read_dir().unwrap().count(), 1);
    }

    #[test]
    fn links_that_lead_nowhere_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let (circle, lost) = (folder.path().join("circle"), folder.path().join("lost"));
        symlink("circle", &circle).unwrap();
        symlink("missing/file", &lost).unwrap();
        let reason = |path: &Path| check_writable(path).unwrap_err().to_string();
        assert!(reason(&circle).ends_with("a link that leads nowhere"));
        assert!(reason(&lost).ends_with("missing; create it first"));
    }

    #[test]
    fn devices_and_pipes_are_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("null.png");
        symlink("/dev/null", &link).unwrap();
        let error = write(&link, &b"new"[..]).unwrap_err().to_string();
        assert!(error.contains("a device or a pipe, not a file"), "{error}");
    }
}
