#include "bench/drawing/bare_loop.h"

#include "engine/core/monotonic_clock.h"
#include "resources/resources.h"
#include "widgets/scene/look/chest_uniforms.h"
#include "widgets/scene/look/organ_shader.h"
#include "widgets/scene/surfaces/merged_surface.h"
#include "widgets/scene/view/orbit_camera.h"

#include <QGuiApplication>
#include <QMatrix4x4>
#include <QOpenGLBuffer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QWindow>

#include <cstddef>
#include <fstream>
#include <limits>

namespace carina::bench
{
namespace
{

/// What they need of the shader.
constexpr OrganShader kOpaque{.hasManyRegions = false,
                              .movesJaw = false,
                              .pushesTissue = false,
                              .changesAirway = false,
                              .bendsNeck = false};

std::vector<MergedSurface> opaqueSurfaces(const PatientScene& patient)
{
    return mergedSurfaces(withLooks(patient.parts(), patient.solid()));
}

/// The triangles of the finest level.
std::vector<Triangle> finest(const PatientScene& patient, const MergedSurface& surface)
{
    const std::vector<int> levels(patient.parts().size(), 0);
    return trianglesAt(levels, surface.pieces, surface.triangles);
}

struct View {
    QMatrix4x4 eyeToScreen;
    QVector3D eye;
};

QVector3D inSingle(const Vec3& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

/// As a SceneView sees it from in front.
View frontView(const PatientScene& patient)
{
    OrbitCamera camera;
    camera.setBounds(patient.framed());
    camera.setAspect(double(kWidth) / kHeight);
    camera.showFrom(ViewPreset::Front);
    const CameraPose pose = camera.pose();
    const Frustum f = camera.frustum();
    View view;
    const auto near = float(pose.nearPlane);
    view.eyeToScreen.frustum(float(f.left) * near, float(f.right) * near, float(f.bottom) * near,
                             float(f.top) * near, near, float(pose.farPlane));
    view.eyeToScreen.lookAt(inSingle(pose.p_A_eye), inSingle(pose.p_A_target), inSingle(pose.up_A));
    view.eye = inSingle(pose.p_A_eye);
    return view;
}

/// One surface on the graphics card.
class Draw
{
public:
    Draw(const MergedSurface& surface, const std::vector<Triangle>& triangles,
         QOpenGLShaderProgram& program)
        : m_key{surface.key},
          m_motion{program.uniformLocation("motion")},
          m_corners(int(3 * triangles.size()))
    {
        m_array.create();
        const QOpenGLVertexArrayObject::Binder bound{&m_array};
        m_vertices.create();
        m_vertices.bind();
        m_vertices.allocate(surface.vertices.data(),
                            int(surface.vertices.size() * sizeof(SurfaceVertex)));
        const auto column = [&program](const char* name, std::size_t offset) {
            program.enableAttributeArray(name);
            program.setAttributeBuffer(name, GL_FLOAT, int(offset), 3, sizeof(SurfaceVertex));
        };
        column("vertexPosition", offsetof(SurfaceVertex, position));
        column("vertexNormal", offsetof(SurfaceVertex, normal));
        column("vertexColor", offsetof(SurfaceVertex, color));
        column("vertexPart", offsetof(SurfaceVertex, part));
        m_indices.create();
        m_indices.bind();
        m_indices.allocate(triangles.data(), int(triangles.size() * sizeof(Triangle)));
    }

    /// @pre the program is bound.
    void operator()(const SceneFrame& frame, QOpenGLShaderProgram& program, QOpenGLFunctions& gl)
    {
        if (!m_key.body.empty() && !frame.bodies.contains(m_key.body))
            return;
        program.setUniformValue(m_motion, motionUniform(frame.chest.of(*m_key.region)));
        const QOpenGLVertexArrayObject::Binder bound{&m_array};
        gl.glDrawElements(GL_TRIANGLES, m_corners, GL_UNSIGNED_INT, nullptr);
    }

private:
    SurfaceKey m_key;
    int m_motion; ///< its uniform
    int m_corners;
    QOpenGLVertexArrayObject m_array;
    QOpenGLBuffer m_vertices{QOpenGLBuffer::VertexBuffer};
    QOpenGLBuffer m_indices{QOpenGLBuffer::IndexBuffer};
};

void setUniforms(QOpenGLShaderProgram& program, const View& view, const SceneFrame& frame)
{
    program.setUniformValue("modelMatrix", QMatrix4x4{});
    program.setUniformValue("modelNormalMatrix", QMatrix3x3{});
    program.setUniformValue("mvp", view.eyeToScreen);
    program.setUniformValue("eyePosition", view.eye);
    program.setUniformValue("chest", chestUniform(frame.chest.field));
}

double drawFor(double seconds, QWindow& window, QOpenGLContext& context,
               QOpenGLShaderProgram& program, const PatientScene& patient,
               std::vector<std::unique_ptr<Draw>>& draws)
{
    QOpenGLFunctions& gl = *context.functions();
    const View view = frontView(patient);
    gl.glViewport(0, 0, kWidth, kHeight);
    gl.glEnable(GL_DEPTH_TEST);
    gl.glEnable(GL_CULL_FACE);
    gl.glClearColor(0.07F, 0.1F, 0.12F, 1.0F);
    int frames = -1; // the first one only makes everything ready
    LocalTime began = monotonicNow();
    double elapsed = 0.0;
    while (elapsed < seconds) {
        const SceneFrame frame = patient.frameAt(elapsed, 0);
        gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        setUniforms(program, view, frame);
        for (const auto& draw : draws)
            (*draw)(frame, program, gl);
        context.swapBuffers(&window);
        if (++frames == 0)
            began = monotonicNow();
        elapsed = toSeconds(monotonicNow() - began);
    }
    return frames / elapsed;
}

} // namespace

Result<double> bareLoopRate(const PatientScene& patient, double seconds)
{
    QWindow window;
    window.setSurfaceType(QSurface::OpenGLSurface);
    window.setFormat(QSurfaceFormat::defaultFormat());
    window.resize(kWidth, kHeight);
    window.show();
    while (!window.isExposed())
        QGuiApplication::processEvents();
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&window))
        return fail(Errc::NoGraphics, "no OpenGL context");
    QOpenGLShaderProgram program;
    if (!program.addShaderFromSourceCode(QOpenGLShader::Vertex, organVertexShader(kOpaque))
        || !program.addShaderFromSourceCode(QOpenGLShader::Fragment, resource("shaders/organ.frag"))
        || !program.link() || !program.bind())
        return fail(Errc::NoGraphics, program.log().toStdString());
    std::vector<std::unique_ptr<Draw>> draws;
    for (const MergedSurface& surface : opaqueSurfaces(patient))
        draws.push_back(std::make_unique<Draw>(surface, finest(patient, surface), program));
    const double rate = drawFor(seconds, window, context, program, patient, draws);
    draws.clear();
    return rate;
}

Result<void> writePly(const PatientScene& patient, const std::filesystem::path& file)
{
    std::vector<SurfaceVertex> vertices;
    std::vector<Triangle> triangles;
    for (const MergedSurface& surface : opaqueSurfaces(patient)) {
        if (surface.key.layer != DrawLayer::Closed)
            continue; // the tube is not in sight
        constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
        std::vector<std::uint32_t> places(surface.vertices.size(), kUnused);
        for (Triangle t : finest(patient, surface)) {
            for (std::uint32_t& corner : t) {
                if (places[corner] == kUnused) {
                    places[corner] = std::uint32_t(vertices.size());
                    vertices.push_back(surface.vertices[corner]);
                }
                corner = places[corner];
            }
            triangles.push_back(t);
        }
    }
    std::ofstream out{file, std::ios::binary};
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << vertices.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
           "property float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
           "property uchar blue\nelement face "
        << triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const SurfaceVertex& v : vertices) {
        out.write(reinterpret_cast<const char*>(v.position.data()), sizeof v.position);
        out.write(reinterpret_cast<const char*>(v.normal.data()), sizeof v.normal);
        for (int k = 0; k < 3; ++k)
            out.put(char(std::uint8_t(255.0F * v.color[k])));
    }
    for (const Triangle& t : triangles) {
        out.put(3);
        out.write(reinterpret_cast<const char*>(t.data()), sizeof t);
    }
    out.close();
    if (!out)
        return fail(Errc::FileUnwritable, file.string());
    return {};
}

} // namespace carina::bench
