#include "models/errors/error_text.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

// A code without its sentence does not compile.
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wswitch"

class ErrorSentences
{
    Q_DECLARE_TR_FUNCTIONS(ErrorText)

public:
    /// %1 takes the particulars in brackets with a blank before them, or nothing.
    static QString of(Errc code)
    {
        switch (code) {
        case Errc::NotFinite:
            return tr("A number is missing or not finite%1: enter a finite number.");
        case Errc::OutOfRange:
            return tr("A value is out of its range%1: choose one within it.");
        case Errc::NotARotation:
            return tr("An orientation is not a valid rotation%1: calibrate or export it again.");
        case Errc::MeshNotClosed:
            return tr("A surface has holes and encloses no volume%1: close it in the program it "
                      "comes from, or leave it out.");
        case Errc::VolumeUnreachable:
            return tr("A lung cannot be drawn with this volume%1: choose a smaller tidal volume.");
        case Errc::NoAirway:
            return tr("This patient has no airway that a tube fits into%1: add the surface of its "
                      "trachea, down to the carina, or choose another set.");
        case Errc::TooFewLandmarks:
            return tr("There are too few landmarks%1: touch at least three.");
        case Errc::DegenerateLandmarks:
            return tr(
                "The patient's position cannot be determined from these landmarks%1: choose "
                "landmarks far apart and not on one line, and touch each of them at its place.");
        case Errc::TooFewPoses:
            return tr("The tracker saw the stylus too rarely to calibrate it%1: keep its tip in "
                      "the divot and its markers in view.");
        case Errc::NotEnoughMotion:
            return tr("The stylus was turned too little%1: swing it to all sides with its tip in "
                      "the divot.");
        case Errc::NotEnoughSpin:
            return tr("The tool was turned too little about its shaft%1: turn it by half a turn or "
                      "more.");
        case Errc::ToolMoved:
            return tr("The tool did not stay in its place%1: keep its tip in the divot or its "
                      "shaft in the bearing, and do it again.");
        case Errc::TooFewPoints:
            return tr(
                "There are too few points on the surface%1: slide the tip over it for longer.");
        case Errc::NoSurfaceFit:
            return tr("The points taken do not match the patient's surface%1: slide the tip over "
                      "the named surface only, or touch the landmarks again.");
        case Errc::NotRegistered:
            return tr("The patient is not registered to the manikin yet%1: finish the steps of "
                      "carina-registration.");
        case Errc::OtherPatient:
            return tr("This site belongs to another patient%1: choose the patient that it was "
                      "registered with, or another site file.");
        case Errc::SiteInUse:
            return tr(
                "Another window has this site open%1: close it, or choose another site file.");
        case Errc::FileNotFound:
            return tr("This file or folder does not exist%1: check its name and location.");
        case Errc::FileUnreadable:
            return tr(
                "A file cannot be read%1: check that it is a file, and that you may read it.");
        case Errc::FileEmpty:
            return tr("A file is empty%1: copy or export it again.");
        case Errc::FileTooLarge:
            return tr("A file is too large%1: choose a smaller one, or reduce it in the program it "
                      "comes from.");
        case Errc::FileMalformed:
            return tr("A file is damaged or incomplete%1: copy or export it again.");
        case Errc::NotConfined:
            return tr("Foreign files are not read, because this system cannot confine the program "
                      "that reads them%1: run Carina on a Linux kernel with seccomp.");
        case Errc::FileUnwritable:
            return tr(
                "A file cannot be written%1: check the free space and that you may write there.");
        case Errc::UnknownFormat:
            return tr("This file format is not supported%1: choose one that this version of Carina "
                      "reads.");
        case Errc::NothingRecognised:
            return tr("Nothing usable was found%1: choose the folder that holds the surfaces.");
        case Errc::Cancelled:
            return tr(
                "This was stopped before it was complete%1: start it again when you want it.");
        case Errc::WrongOption:
            return tr("The command line is not valid%1: --help explains each option.");
        case Errc::WrongAddress:
            return tr("This is not a network address%1: type the address that the instructor's "
                      "window shows, such as 192.168.1.20.");
        case Errc::PacketMalformed:
            return tr("Invalid data were received%1: make sure that only Carina uses this port.");
        case Errc::VersionMismatch:
            return tr("The other computer runs another version of Carina%1: install the same "
                      "version on both.");
        case Errc::AddressInUse:
            return tr("Another program uses this port%1: close it or choose another port.");
        case Errc::StoreFailed:
            return tr("The session could not be saved%1: check the free space, that you may write "
                      "there, and that no other program has it open.");
        case Errc::StoreCorrupt:
            return tr("The saved session is damaged%1: restore it from a copy, or start a new "
                      "session.");
        case Errc::StoreTooOld:
            return tr("This session was saved by an earlier version of Carina%1: open it with that "
                      "version, or start a new session.");
        case Errc::StoreReplaced:
            return tr(
                "The file of this session was deleted or changed by somebody else%1: "
                "everything is saved in a new file, which goes on; find out what changed it.");
        case Errc::ClockLost:
            return tr("The clock of the saved session is wrong%1: its time goes on from the last "
                      "change; check the times in its report.");
        case Errc::NotPermitted:
            return tr("Your role may not do this%1: ask an instructor.");
        case Errc::SessionEnded:
            return tr("The session has ended%1: start a new one to make changes.");
        case Errc::NameTaken:
            return tr("This name and role are in use by another computer, or were%1: choose "
                      "another name, or ask the instructor.");
        case Errc::NameUnclear:
            return tr("This name cannot be told from another one, or has characters that cannot be "
                      "seen%1: choose another, plain name.");
        case Errc::SessionFull:
            return tr("The session is full%1: ask the instructor who can leave, or join later.");
        case Errc::TooMuchSent:
            return tr("This program sent more than its role may%1: wait half a minute, then join "
                      "again.");
        case Errc::Muted:
            return tr("An instructor has muted you%1: you see everything, and nothing that you do "
                      "has an effect; ask the instructor.");
        case Errc::Removed:
            return tr("You were removed from the session%1: ask the instructor before you join "
                      "again.");
        case Errc::Banned:
            return tr("You were removed from the session and may not come back%1: ask the "
                      "instructor.");
        case Errc::SessionLocked:
            return tr("The session is locked and takes nobody new%1: ask the instructor.");
        case Errc::UsedElsewhere:
            return tr("Another program came in with your name and token, and this one had to "
                      "leave%1: if that was not you, tell the instructor.");
        case Errc::StationUnknown:
            return tr("The session has no such open station%1: choose one of those that are open.");
        case Errc::StationOccupied:
            return tr("Participants are at this station%1: move them to another one first.");
        case Errc::StationCount:
            return tr("A session has one to eight open stations%1: close another one first, or add "
                      "one before you close the last.");
        case Errc::WrongCode:
            return tr("This code is not valid for the session%1: ask the instructor for the code "
                      "of your role and join with it.");
        case Errc::WrongLink:
            return tr("This is not a valid link to a session%1: copy the complete link from the "
                      "instructor's window, or type address, port and code.");
        case Errc::NotEnoughMemory:
            return tr("There is too little memory to check the code%1: close other programs and "
                      "start again.");
        case Errc::OwnerChanged:
            return tr("Another participant has taken this object%1: check who owns it now, then "
                      "try again.");
        case Errc::SetNotNamed:
            return tr("No station of the session has this patient%1: ask the instructor which "
                      "patient to use.");
        case Errc::SetWithdrawn:
            return tr("The instructor's computer no longer has this patient%1: ask the instructor "
                      "to start the session with it again.");
        case Errc::HostSilent:
            return tr("The instructor's computer does not answer the request for its patient%1: "
                      "check that no firewall blocks it.");
        case Errc::CertificateExpired:
            return tr("A certificate is not valid today%1: check the date on this computer, or "
                      "have the certificate renewed.");
        case Errc::CertificateUntrusted:
            return tr("The session's certificate was not issued by an authority that this computer "
                      "trusts%1: ask for the authority's file and start again with --authority.");
        case Errc::CertificateOfAnother:
            return tr("The session's certificate is for another name%1: compare address and name "
                      "with the instructor's window.");
        case Errc::CertificateMissing:
            return tr("A certificate is expected, and this session has none%1: check address and "
                      "port, or start again without the name of a certificate.");
        case Errc::CertificateNeeded:
            return tr("This session uses a certificate%1: use the link in the instructor's window, "
                      "or type the name that it shows.");
        case Errc::KeyDoesNotFit:
            return tr("The private key does not match the certificate%1: choose two files that "
                      "belong together.");
        case Errc::TrackerFailed:
            return tr("Not everything is tracked%1: where the tracker does not answer, check its "
                      "cable and power; it is tried again by itself.");
        case Errc::DeviceReplyDamaged:
            return tr("What the device sent is damaged%1: check its cable and its rate of "
                      "transmission.");
        case Errc::NoGraphics:
            return tr("The picture cannot be drawn%1: start the program on a computer with a "
                      "display and the driver of its graphics card.");
        }
        return {};
    }

    static QString particulars(const std::string& detail)
    {
        return detail.empty() ? QString{} : tr(" (%1)").arg(QString::fromStdString(detail));
    }
};

#pragma GCC diagnostic pop

} // namespace

QString errorText(const Error& error)
{
    // Not by arg, which would take a %1 in the particulars for its own.
    return ErrorSentences::of(error.code)
        .replace(QLatin1String("%1"), ErrorSentences::particulars(error.detail));
}

} // namespace carina
