//! What minifb 0.29 does not survive on a display of X11: where it means to return an error, it frees memory twice.
//! So both cases are kept from it. A crate that speaks X11 would take 5 s of the first build.

use std::io::{Read, Write};
use std::os::unix::net::UnixStream;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::Command;
use std::time::Duration;
use std::{env, fs};

use command_line::NotShown;

/// Begins the program anew if it shall use an input method, which may not be there: keys need none. A variable of the
/// environment can be removed for a new program only.
fn leave_input_method() {
    if env::var_os("XMODIFIERS").is_none() {
        return;
    }
    if let Ok(program) = env::current_exe() {
        let mut command = Command::new(program);
        // It returns only if it fails.
        let _ = command
            .args(env::args_os().skip(1))
            .env_remove("XMODIFIERS")
            .exec();
    }
}

/// A connection to the display, and the width and height of its screen, if it is on this machine and answers. A display whose last program has left may
/// begin anew and refuse the next for a moment, so the caller holds the connection until its window is open. An error
/// if minifb has no colours for the display, or would end the program.
pub fn check() -> Result<Option<(UnixStream, [u16; 2])>, NotShown> {
    leave_input_method();
    let Some((connection, format, screen)) = connect() else {
        return Ok(None);
    };
    // The depth is the number of bits that have a meaning: 8 for a colour, and 8 more for how opaque it is.
    if matches!((format[0], format[1]), (24 | 32, 32)) {
        return Ok(Some((connection, screen)));
    }
    let reason = format!(
        "no display with colours of 24 bits to open it on (it has {})",
        format[0]
    );
    Err(NotShown::NoWindow(reason))
}

/// A connection to the display, the depth and the bits of a pixel there, and the sides of its screen.
type Display = (UnixStream, [u8; 2], [u16; 2]);

/// The display on this machine.
fn connect() -> Option<Display> {
    let display = env::var("DISPLAY").ok()?;
    let number = display.strip_prefix(':')?.split('.').next()?;
    let server = Path::new("/tmp/.X11-unix").join(format!("X{number}"));
    let mut cookies = cookies(number);
    cookies.push(Vec::new());
    cookies.iter().find_map(|cookie| ask(&server, cookie))
}

/// The secrets with which programs of this person may speak to a display, from entries of five fields:
/// family, host, number of the display, name and secret.
fn cookies(display: &str) -> Vec<Vec<u8>> {
    let home = env::home_dir().unwrap_or_default().join(".Xauthority");
    let path = env::var_os("XAUTHORITY").map_or(home, Into::into);
    let bytes = fs::read(path).unwrap_or_default();
    let mut rest = &bytes[..];
    let mut cookies = Vec::new();
    while let Some((_, mut after)) = rest.split_at_checked(2) {
        let mut fields = [&[][..]; 4];
        for field in &mut fields {
            let Some((length, start)) = after.split_first_chunk() else {
                return cookies;
            };
            let length = u16::from_be_bytes(*length).into();
            let Some(split) = start.split_at_checked(length) else {
                return cookies;
            };
            (*field, after) = split;
        }
        if fields[1] == display.as_bytes() && fields[2] == NAME {
            cookies.push(fields[3].to_vec());
        }
        rest = after;
    }
    cookies
}

/// The name of the secrets.
const NAME: &[u8] = b"MIT-MAGIC-COOKIE-1";

/// Begins to speak X11, version 11.0, with a server, which answers with its pixels and its screen. The
/// numbers are places in chapter 8 of its protocol.
fn ask(server: &Path, cookie: &[u8]) -> Option<Display> {
    let name = if cookie.is_empty() { &[] } else { NAME };
    let mut request = vec![
        b'l',
        0,
        11,
        0,
        0,
        0,
        name.len() as u8,
        0,
        cookie.len() as u8,
        0,
        0,
        0,
    ];
    for text in [name, cookie] {
        request.extend(text);
        request.resize(request.len().next_multiple_of(4), 0);
    }
    let mut stream = UnixStream::connect(server).ok()?;
    stream.set_read_timeout(Some(Duration::from_secs(1))).ok()?;
    stream.write_all(&request).ok()?;
    let mut head = [0; 8];
    stream.read_exact(&mut head).ok()?;
    let number =
        |bytes: &[u8], at: usize| Some(u16::from_le_bytes([*bytes.get(at)?, *bytes.get(at + 1)?]));
    let mut answer = vec![0; 4 * usize::from(number(&head, 6)?)];
    stream.read_exact(&mut answer).ok()?;
    let vendor = usize::from(number(&answer, 16)?);
    let start = 32 + vendor.next_multiple_of(4);
    let end = start + 8 * usize::from(*answer.get(21)?);
    let depth = *answer.get(end + 38)?;
    let mut formats = answer.get(start..end)?.chunks_exact(8);
    let format = formats.find(|format| format[0] == depth && head[0] == 1)?;
    let screen = [number(&answer, end + 20)?, number(&answer, end + 22)?];
    Some((stream, [format[0], format[1]], screen))
}
