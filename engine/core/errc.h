#pragma once

#include <cstdint>

namespace carina
{

/// What went wrong. Every code has one translated sentence in models/error_text that says what to
/// do next; a code without a sentence does not compile there.
enum class Errc : std::uint8_t {
    // Numbers and geometry
    NotFinite,         ///< a NaN or an infinity where a number is needed
    OutOfRange,        ///< a value outside the range its quantity may take
    NotARotation,      ///< a matrix that is not a proper rotation
    MeshNotClosed,     ///< a surface that encloses no volume
    VolumeUnreachable, ///< no deformation of the mesh has the volume asked for
    NoAirway,          ///< an anatomy without an airway that a tube fits into

    // Registration
    TooFewLandmarks,     ///< fewer than a fit needs
    DegenerateLandmarks, ///< at one place, on one line, or otherwise without one best fit
    TooFewPoses,         ///< fewer poses of a stylus, or fewer that agree, than a calibration needs
    NotEnoughMotion,     ///< the stylus was turned too little to know its tip
    NotEnoughSpin,       ///< a tool was spun too little to know its axis
    ToolMoved,           ///< a tip or an axis that had to stand still did not
    TooFewPoints,        ///< fewer of a swabbed surface than a refinement needs
    NoSurfaceFit,        ///< a swab that a surface does not fit
    NotRegistered,       ///< a site whose anatomy was not yet fitted to its manikin
    OtherPatient,        ///< a site that was registered for another patient
    SiteInUse,           ///< another program works on the same site

    // Files
    FileNotFound,      ///< no such file or folder
    FileUnreadable,    ///< it is there and cannot be read
    FileEmpty,         ///< it holds nothing
    FileMalformed,     ///< it is truncated or does not follow its format
    FileUnwritable,    ///< it cannot be written
    UnknownFormat,     ///< no reader for this kind of file
    NothingRecognised, ///< a folder without one usable part
    Cancelled,         ///< stopped by whoever asked for it

    // Command line and forms
    WrongOption,  ///< an option that cannot be used as it was given
    WrongAddress, ///< a text that is no address of a computer

    // Network and session
    PacketMalformed, ///< bytes that are not a Carina datagram
    VersionMismatch, ///< the peer speaks another version of the protocol
    AddressInUse,    ///< the port is taken
    StoreFailed,     ///< the fact log could not be written
    StoreCorrupt,    ///< the fact log could not be read back whole
    NotPermitted,    ///< the role may not do this
    SessionEnded,    ///< the session takes no more changes
    NameTaken,       ///< somebody with the same name and role is in the session now
    WrongCode,       ///< no join code of this session and role
    WrongLink,       ///< a text that is no link into a session
    NotEnoughMemory, ///< too little to derive a key from a join code
    OwnerChanged,    ///< the object has passed to somebody else meanwhile
    SetNotNamed,     ///< no station of the session has the patient that was asked for
    SetWithdrawn,    ///< the host has not got the patient's surfaces any more
    HostSilent,      ///< the host does not answer over TCP

    // Certificates
    CertificateExpired,   ///< not valid today, or not yet
    CertificateUntrusted, ///< from no authority that is trusted
    CertificateOfAnother, ///< for another name than the one expected
    CertificateMissing,   ///< expected of a host that has none
    CertificateNeeded,    ///< the host has one, and none was expected
    KeyDoesNotFit,        ///< a private key that is not the certificate's

    // Devices and graphics
    TrackerFailed, ///< the tracker could not be started
    NoGraphics,    ///< no OpenGL where a picture is needed
};

} // namespace carina
