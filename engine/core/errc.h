#pragma once

#include <cstdint>

namespace carina
{

/// What went wrong. Every code has one translated sentence in models/errors/error_text that says
/// what to do next; a code without a sentence does not compile there.
enum class Errc : std::uint8_t {
    // Numbers and geometry
    NotFinite,         ///< a NaN or an infinity where a number is needed
    OutOfRange,        ///< a value outside the range its quantity may take
    NotARotation,      ///< a matrix that is not a proper rotation
    MeshNotClosed,     ///< a surface that encloses no volume
    VolumeUnreachable, ///< no deformation of the mesh has the requested volume
    NoAirway,          ///< an anatomy without an airway that a tube fits into

    // Registration
    TooFewLandmarks,     ///< fewer landmarks than a fit needs
    DegenerateLandmarks, ///< coincident, collinear, or without a unique best fit
    TooFewPoses,         ///< fewer poses of a stylus than a calibration needs
    NotEnoughMotion,     ///< the stylus was turned too little to determine its tip
    NotEnoughSpin,       ///< a tool was spun too little to determine its axis
    ToolMoved,           ///< the tip or axis moved during its calibration
    TooFewPoints,        ///< fewer points touched on a surface than its refinement needs
    NoSurfaceFit,        ///< the points touched on a surface do not fit it
    NotRegistered,       ///< a site whose anatomy was not yet fitted to its manikin
    OtherPatient,        ///< a site that was registered for another patient
    SiteInUse,           ///< another program works on the same site

    // Files
    FileNotFound,      ///< no such file or folder
    FileUnreadable,    ///< it exists but cannot be read
    FileEmpty,         ///< it has no content
    FileTooLarge,      ///< more than is read of a file of its kind
    FileMalformed,     ///< it is truncated or does not follow its format
    NotConfined,       ///< the program that reads foreign files cannot be confined
    FileUnwritable,    ///< it cannot be written
    UnknownFormat,     ///< no reader for this kind of file
    NothingRecognised, ///< a folder without any usable part
    Cancelled,         ///< stopped on request

    // Command line and forms
    WrongOption,  ///< an option that cannot be used as it was given
    WrongAddress, ///< a text that is not the address of a computer

    // Network and session
    PacketMalformed, ///< bytes that are not a Carina datagram
    VersionMismatch, ///< the peer speaks another version of the protocol
    AddressInUse,    ///< the port is taken
    StoreFailed,     ///< the fact log could not be written
    StoreCorrupt,    ///< the fact log could not be read completely
    StoreTooOld,     ///< the fact log is of an earlier version of Carina and cannot be read
    StoreReplaced,  ///< the file of the fact log was deleted, replaced or changed while it was open
    ClockLost,      ///< the stored clock of a session contradicts its log
    NotPermitted,   ///< the role may not do this
    SessionEnded,   ///< the session takes no more changes
    NameTaken,      ///< the name and role of another program, or of who has a token for them
    NameUnclear,    ///< a name with invisible characters, or one that looks like another's
    SessionFull,    ///< no more participants of this role are taken
    TooMuchSent,    ///< more than a participant of this role may send
    Muted,          ///< an instructor has muted the participant
    Removed,        ///< an instructor has removed the participant
    Banned,         ///< an instructor has removed the participant for good
    SessionLocked,  ///< the session admits nobody new
    UsedElsewhere,  ///< the participant's token was used by another program
    StationUnknown, ///< no open station of the session has this name or number
    StationOccupied, ///< a station cannot be closed while participants are at it
    StationCount,    ///< a session would have no open station left, or too many
    WrongCode,       ///< not a join code of this session and role
    WrongLink,       ///< a text that is not a link to a session
    NotEnoughMemory, ///< too little memory to derive a key from a join code
    OwnerChanged,    ///< the object has another owner in the meantime
    SetNotNamed,     ///< no station of the session has the requested patient
    SetWithdrawn,    ///< the host no longer has the patient's surfaces
    HostSilent,      ///< the host does not answer over TCP

    // Certificates
    CertificateExpired,   ///< expired, or not yet valid
    CertificateUntrusted, ///< not issued by a trusted authority
    CertificateOfAnother, ///< issued for another name than the expected one
    CertificateMissing,   ///< expected, but the host has none
    CertificateNeeded,    ///< not expected, but the host has one
    KeyDoesNotFit,        ///< a private key that does not belong to the certificate

    // Devices and graphics
    TrackerFailed,      ///< the tracker could not be started
    DeviceReplyDamaged, ///< bytes of a device that are none of its replies
    NoGraphics,         ///< no OpenGL to draw a picture with
};

} // namespace carina
