// seeds DIR: whole messages for the fuzzers to begin with, in a folder below DIR for each.

#include "engine/io/anatomy_set/set_codec.h"
#include "engine/io/mesh/mesh_file_codec.h"
#include "engine/io/scoring/rubric_file.h"
#include "engine/io/site/site_json.h"
#include "engine/net/discovery/session_notice.h"
#include "engine/net/entry/join_link.h"
#include "engine/net/entry/role_proof.h"
#include "engine/net/entry/token_message.h"
#include "engine/net/secure/dtls_record.h"
#include "engine/physiology/body_fold.h"
#include "engine/session/facts/fact_codec.h"
#include "engine/sync/strategies/relayed_message.h"
#include "engine/tracking/ndi/tool_definition.h"
#include "tests/engine/io/anatomy_set/carried_set_files.h"
#include "tests/engine/io/mesh/texture_files.h"
#include "tests/engine/io/site/landmark_samples.h"
#include "tests/engine/io/site/site_sample.h"
#include "tests/engine/net/anatomy_transfer/frame_samples.h"
#include "tests/engine/sync/wire/datagram_samples.h"
#include "tests/engine/tracking/igtl/igtl_samples.h"
#include "tests/engine/tracking/ndi/ndi_samples.h"
#include "tests/fuzz/set_under_seal.h"

#include <QJsonDocument>

#include <algorithm>
#include <fstream>

namespace
{

using namespace carina;

const std::string kSession = "00112233445566778899aabbccddeeff";

std::string textOf(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<std::string> datagrams()
{
    const std::string header = textOf(fromHex(kGoldenHeaderHex));
    std::vector<std::string> all;
    for (const GoldenRecord& golden : goldenRecords())
        all.push_back(header + textOf(fromHex(golden.hex)));
    return all;
}

/// A record of DTLS, RFC 6347, 4.1.
std::string dtls(char type, char epoch, const std::string& fragment)
{
    return std::string{type, '\xFE', '\xFD', 0, epoch, 0, 0, 0, 0, 0, 0, 0}
           + static_cast<char>(fragment.size()) + fragment;
}

std::vector<std::string> entries()
{
    const AccessKey key = *keyFromHex(std::string(64, '7'));
    const PskIdentity newcomer{{Role::Trainee, std::nullopt}, kSession};
    const PskIdentity anna{{Role::Observer, ParticipantId{7}}, kSession};
    JoinLink link{"192.0.2.7", 45000, Role::Observer, *JoinCode::parse("7K3QMXW2PD")};
    std::vector<std::string> all{toText(link), link.code.text(), toText(newcomer), toText(anna)};
    link.certificate = "carina.example";
    all.push_back(toText(link));
    const std::vector<std::vector<std::byte>> messages{
        encodeQuestion({.nonce = 7}),
        encodeAnswer(0, {goldenKey(), "Ward 3", 45000}),
        encodeToken({ParticipantId{7}, key}),
        encodeChallenge({kSession, key}),
        encodeProof({anna, key}),
        encodeProof({newcomer, key}),
        encodeVerdict(true),
        encodeVerdict(false)};
    for (const auto& message : messages)
        all.push_back(textOf(message));
    all.push_back(textOf(std::as_bytes(wrongKeyAlert())));
    all.push_back(dtls(21, 0, {2, 40}));
    all.push_back(dtls(22, 0, {1, 0, 0}));
    all.push_back(dtls(22, 0, {16, 0, 0}) + dtls(20, 0, {1}) + dtls(22, 1, "finished"));
    return all;
}

std::vector<std::string> frames()
{
    std::vector<std::string> all(1);
    for (const test::GoldenFrame& golden : test::goldenFrames()) {
        all.push_back(golden.bytes);
        all.front() += golden.bytes;
    }
    return all;
}

std::vector<std::string> sets()
{
    const auto withoutSeal = [](const ImportedSet& set) {
        return textOf(encodeSet(set)).substr(fuzz::kSealBytes);
    };
    ImportedSet painted = test::carriedSample();
    for (AnatomyPart& part : painted.anatomy.parts)
        for (const TriangleMesh& level : part.levels)
            part.colors.emplace_back(level.positions.size(), Rgb{200, 120, 90});
    return {withoutSeal(test::carriedSample()), withoutSeal(painted), withoutSeal({})};
}

std::vector<std::string> pictures()
{
    constexpr int kSide = 16;
    const auto pixels = test::pixelsOf(kSide, [](double u, double v) {
        return test::Pixel{static_cast<unsigned char>(255 * u), static_cast<unsigned char>(255 * v),
                           9};
    });
    return {test::pngOf(kSide, pixels), test::jpegOf(kSide, pixels)};
}

/// The first byte chooses the decoder.
std::vector<std::string> landmarks()
{
    return {"0" + test::kLandmarkTable, "1" + test::kSlicerPoints, "1" + test::kSlicerPointsRas,
            "2" + test::kSlicerMarkups, "2" + test::kSlicerMarkupsRas};
}

std::vector<std::string> relayed()
{
    const ParticipantId from{1};
    return {textOf(encodeRelayed({from, kAllOthers, goldenEvent()})),
            textOf(encodeRelayed({from, ParticipantId{2}, DelayProbe{Duration{7}}})),
            textOf(encodeRelayed({from, ParticipantId{2}, DelayAnswer{Duration{-7}}}))};
}

/// One of each kind; the first byte chooses who proposes it, and at which station.
std::vector<std::string> factBodies()
{
    const ParticipantId self{2};
    const LungConditions asthma{{ConditionKind::Asthma, 0.5, ConditionSide::Both}};
    const FactBody bodies[] = {
        fact::SessionCreated{"Session", "00ff"},
        fact::PhaseChanged{SessionPhase::Running},
        fact::StationAdded{"Station 2"},
        fact::ParticipantJoined{{}, Role::Observer, "Newcomer"},
        fact::ParticipantLeft{self},
        fact::ObjectShared{{}, self, ObjectKind::Stylus, "Stylus"},
        fact::AnatomyChosen{"ab", "Adult"},
        fact::BreathingRateSet{perMinute(20.0)},
        fact::TidalVolumeSet{millilitres(300.0)},
        fact::InspiratoryFractionSet{0.4},
        fact::ObjectHandedOver{ObjectId{1}, ParticipantId{1}, 1},
        fact::ObjectWanted{ObjectId{1}, true},
        fact::PatientBuildSet{{metres(1.7), 70.0, 40.0, Sex::Female}},
        fact::LungConditionsSet{asthma},
        fact::VentilatorSet{},
        fact::TubePlaced{{TubeSeat::LeftMain, millimetres(7.0)}},
        fact::ManikinBreathed{SessionTime{std::chrono::seconds{99}}},
        fact::RespirationCheckpoint{{}, RespiratoryFold{RespiratorySettings{}}.state()},
        fact::BodyPositionSet{},
        fact::ParticipantMuted{self, true},
        fact::ParticipantRemoved{self, true, "too loud"},
        fact::BanLifted{self},
        fact::SessionLocked{true},
        fact::RoleCodeChanged{Role::Observer},
        fact::TokenReplaced{self},
        fact::StrategyChosen{},
        fact::RegistrationStated{{RegistrationState::Good, StaleReason::None, millimetres(1.0)}},
        fact::StationRenamed{"Room 5"},
        fact::StationClosed{},
        fact::ParticipantMoved{self},
        fact::WorkTaken{ParticipantId{4}, self},
        fact::PlaceChosen{self, degrees(90.0)},
        fact::BreathingStopped{true, std::chrono::seconds{30}},
        fact::BagSqueezed{{perMinute(10.0), millilitres(400.0)}},
        fact::LessonShown{self,
                          {{true, LessonCut::AllButAirway, {0.0, -1.0, 0.0}, 0.01},
                           true,
                           {{1, 3, LessonStyle::Ghost}, {7, 7, LessonStyle::Solid, true, true}}}},
        fact::LessonEnded{},
        fact::ParticipantFellSilent{self},
        fact::AirwayEventsSet{{{AirwayEventKind::TongueOedema, 0.5},
                               {AirwayEventKind::Laryngospasm, 1.0},
                               {AirwayEventKind::LaryngealWeb, 0.25},
                               {AirwayEventKind::Trismus, 0.75},
                               {AirwayEventKind::StiffNeck, 0.5},
                               {AirwayEventKind::Burn, 0.75},
                               {AirwayEventKind::Vomit, 1.0},
                               {AirwayEventKind::FragileTeeth, 0.25},
                               {AirwayEventKind::Swallowing, 0.5}},
                              std::chrono::seconds{30}},
        fact::HeadPositionSet{kSniffing, std::chrono::seconds{30}},
        fact::GasSupplySet{{0.8, true, true}},
        fact::DrugGiven{{DrugKind::Rocuronium, 40.0}},
        fact::CuffSet{true},
        fact::StyletDrawn{},
        fact::TryEnded{},
        fact::TubeObstructed{0.6},
        fact::IntubationNoted{{.step = IntubationStep::ThroughCords,
                               .at = SessionTime{std::chrono::seconds{99}},
                               .seat = TubeSeat::Trachea,
                               .confidence = 0.9,
                               .depthAtTeeth = millimetres(140.0),
                               .tipAboveCarina = millimetres(60.0)},
                              millimetres(6.5)},
        fact::CapnographCheckpoint{},
        fact::BodyCheckpoint{{}, BodyFold{BodySettings{}}.state()}};
    static_assert(std::size(bodies) == std::variant_size_v<FactBody>, "one of each kind");
    std::vector<std::string> all;
    const auto add = [&all](const FactBody& body) {
        for (const char author : {'\0', '\1', '\2', '\4'})
            all.push_back(author + textOf(encodeBody(body)));
    };
    std::ranges::for_each(bodies, add);
    add(fact::RegistrationStated{{RegistrationState::NoTracker, StaleReason::None, {}}});
    return all;
}

/// The first byte says whether the checksum is put right.
std::vector<std::string> tools()
{
    const ToolMarker markers[] = {{{0, 0, 0}, Vec3::UnitZ()}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
    const auto tool =
        NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "tube");
    const std::string bytes = textOf(tool->bytes());
    return {'\0' + bytes, '\1' + bytes};
}

std::vector<std::string> trackers()
{
    const std::string begin = R"({"schema": "carina.tracker/1", "kind": "ndi", "address": "a", )";
    const std::string end = R"("tools": [{"name": "Tube", "role": "tube", "definition": "tube.rom"},
                                         {"name": "Chin", "role": "jaw"}]})";
    const std::string camera = R"({"schema": "carina.tracker/1", "kind": "camera",
        "address": "/dev/video0", "calibration": "camera.yml", "looped": true, "rate": 30,
        "tools": [{"name": "Tube", "role": "tube", "definition": "markers.json"}]})";
    return {begin + end, begin + R"("poses": "BX2", "fastest_rate": 115200, )" + end, camera};
}

std::vector<std::string> cameras()
{
    return {
        R"({"schema": "carina.camera/1", "width": 640, "height": 480, "focal_px": [560, 557],
                "centre_px": [322, 236], "distortion": [0.1, -0.2, 0.001, 0.002, 0],
                "rms_px": 0.3, "pictures": 21, "made_at": "2004-03-27T10:15:00Z"})",
        "image_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n   rows: 3\n"
        "   data: [ 7.09e+002, 0., 332.5, 0., 705.25, 226., 0., 0., 1. ]\n"
        "distortion_coefficients: !!opencv-matrix\n   data: [ 8.2e-002, -0.5, 5e-3, -1.5e-2 ]\n",
        R"({"schema": "carina.markers/1", "dictionary": "4x4_50", "markers": [
                {"id": 6, "side_mm": 27, "X_BK_mm":
                [[0, 0, 1, 18], [1, 0, 0, 0], [0, 1, 0, 18], [0, 0, 0, 1]]}]})"};
}

std::vector<std::string> sites()
{
    Site onlyBegun;
    std::vector<std::string> all;
    for (const Site& site : {test::wholeSite(), onlyBegun})
        for (const QString& schema : {kSiteSchema, kEarlierSiteSchemas[0]}) {
            QJsonObject object = jsonSite(site);
            object.insert(QStringLiteral("schema"), schema);
            all.push_back(QJsonDocument{object}.toJson(QJsonDocument::Compact).toStdString());
        }
    return all;
}

std::vector<std::string> manikins()
{
    const QJsonObject manikin = jsonSite(test::wholeSite())[QStringLiteral("manikin")].toObject();
    return {QJsonDocument{manikin}.toJson(QJsonDocument::Compact).toStdString()};
}

std::vector<std::string> rubrics()
{
    return {QJsonDocument{jsonRubric(publishedRubric())}.toJson().toStdString()};
}

std::vector<std::string> trajectories()
{
    return {
        "# timestamp tx ty tz qx qy qz qw\n1305031102.175304 1.3405 0.6266 1.6575 0.6574 0.6126 "
        "-0.2949 -0.3248\n1305031102.211214 1.3303 0.6256 1.6464 0.6579 0.6161 -0.2932 "
        "-0.3189\n",
        "0 0 0 0 0 0 0 1\n\n1e-3 -1 2.5e2 0 0 0 1 0\n"};
}

std::vector<std::string> deviceSets()
{
    return {R"(<PlusConfiguration version="2.3"><DataCollection>
<Device Id="T" Type="PolarisTracker" SerialPort="1" BaudRate="115200" ToolReferenceFrame="Tracker">
<DataSources><DataSource Type="Tool" Id="Tube" PortName="4" RomFile="tube.rom"/>
<DataSource Type="Tool" Id="Chin" PortName="0"/></DataSources></Device>
</DataCollection></PlusConfiguration>)",
            R"(<PlusConfiguration><Device Type="OpenIGTLinkTracker" ServerAddress="a" ServerPort="1"
MessageType="TDATA"><DataSources><DataSource Type="Tool" Id="Tube"/></DataSources></Device>
</PlusConfiguration>)"};
}

std::vector<std::string> poseRecords()
{
    return {"# carina.poses/1\n"
            "time_s,x_mm,y_mm,z_mm,qx,qy,qz,qw,error_mm,state,role,tool\n"
            "1.000000000,1.5,-2,3,0,0,0,1,0.25,tracked,tube,\"Tube\"\n"
            "1.016,1.5,-2,3,0,0,0.6,0.8,0.25,partly,other,\"a \"\"b\"\"\"\n"
            "1.033,1.5,-2,3,0,0,0,1,0,lost,tube,\"Tube\"\n"};
}

std::vector<std::string> conversations()
{
    return {R"(# carina.conversation/1 {"address":"a:1","kind":"ndi","poses":"TX","rate":115200,)"
            R"("tools":[{"name":"Tube","role":"tube"}]})"
            "\n100.0 : (INFO) opened\n"
            "100.0 : (INFO) 1. command[10] INIT:E3A5\\x0D\n"
            "100.1 : (INFO) 1. receive[9] OKAYA896\\x0D\n",
            R"(# carina.conversation/1 {"address":"a:1","kind":"openigtlink","poses":"TRANSFORM",)"
            R"("rate":60,"tools":[{"device":"Tube","name":"Tube","role":"tube"}]})"
            "\n100.0 : (INFO) opened\n100.1 : (INFO) 0. receive[4] \\x00\\x01TR\n",
            "1. command[14] TX:0001031A\\x0D\n1. receive[9] 0000D166\\x0D\n"};
}

/// In front of the messages two bytes, which say how they are read.
std::vector<std::string> igtl()
{
    std::vector<std::string> all{std::string{"\1\1"}};
    for (const IgtlMessage& message : test::igtlSamples()) {
        all.push_back("\1\1" + textOf(encodeIgtl(message)));
        all.front() += textOf(encodeIgtl(message));
    }
    return all;
}

/// In front of each three bytes, which say what reads it and with which options.
std::vector<std::string> ndiReplies()
{
    std::vector<std::string> all;
    for (const test::NdiSample& sample : test::ndiSamples())
        all.push_back(std::string{static_cast<char>(sample.reader),
                                  static_cast<char>(sample.options),
                                  static_cast<char>(sample.options >> 8U)}
                      + sample.bytes);
    return all;
}

std::vector<std::string> sequences()
{
    return {"ObjectType = Image\nNDims = 3\nDimSize = 0 0 2\n"
            "Seq_Frame0000_StylusToTrackerTransform = 1 0 0 5 0 1 0 -2.5 0 0 1 1e2 0 0 0 1\n"
            "Seq_Frame0000_StylusToTrackerTransformStatus = OK\n"
            "Seq_Frame0000_Timestamp = 0.5\n"
            "Seq_Frame0001_StylusToTrackerTransform = 1 0 0 5 0 1 0 -2.5 0 0 1 1e2 0 0 0 1\n"
            "Seq_Frame0001_StylusToTrackerTransformStatus = MISSING\n"
            "Seq_Frame0001_Timestamp = 0.75\n"
            "ElementDataFile = LOCAL\n"};
}

std::vector<std::string> surfaceAnswers()
{
    NamedSurface corner{"Trachea", "FMA7394", {}, {}};
    corner.mesh.positions = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
    corner.mesh.triangles = {{0, 1, 2}};
    corner.colors = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    const MeshFile file{{corner}, {"a licence"}, {Error{Errc::FileMalformed, "a texture"}}};
    return {textOf(encodeMeshFile(file)),
            textOf(encodeMeshFile(Result<MeshFile>{fail(Errc::FileTooLarge, "a file")}))};
}

bool areWritten(const std::filesystem::path& folder, const std::vector<std::string>& all)
{
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const std::string& bytes : all) {
        std::ofstream file{folder / std::to_string(++number), std::ios::binary};
        if (!(file << bytes))
            return false;
    }
    return true;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
        return 2;
    const std::filesystem::path folder{argv[1]};
    const bool written =
        areWritten(folder / "datagram", datagrams()) && areWritten(folder / "entry", entries())
        && areWritten(folder / "transfer", frames()) && areWritten(folder / "set", sets())
        && areWritten(folder / "igtl", igtl()) && areWritten(folder / "landmark", landmarks())
        && areWritten(folder / "picture", pictures()) && areWritten(folder / "relayed", relayed())
        && areWritten(folder / "fact_body", factBodies()) && areWritten(folder / "tool", tools())
        && areWritten(folder / "tracker", trackers()) && areWritten(folder / "camera", cameras())
        && areWritten(folder / "site", sites()) && areWritten(folder / "manikin", manikins())
        && areWritten(folder / "tum", trajectories()) && areWritten(folder / "plus", deviceSets())
        && areWritten(folder / "record", poseRecords()) && areWritten(folder / "ndi", ndiReplies())
        && areWritten(folder / "rubric", rubrics()) && areWritten(folder / "sequence", sequences())
        && areWritten(folder / "surfaces", surfaceAnswers())
        && areWritten(folder / "conversation", conversations());
    return written ? 0 : 1;
}
