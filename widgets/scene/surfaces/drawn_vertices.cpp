#include "widgets/scene/surfaces/drawn_vertices.h"

#include "engine/core/expects.h"
#include "widgets/scene/look/chest_uniforms.h"
#include "widgets/scene/look/organ_shader.h"

#include <QMatrix4x4>
#include <QOffscreenSurface>
#include <QOpenGLBuffer>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <array>

namespace carina
{
namespace
{

/// Outputs of the shader that are captured, in the order of the buffers that take them.
constexpr std::array<const char*, 2> kCaptured{"worldPosition", "worldNormal"};
constexpr std::size_t kPositions = 0;
constexpr std::size_t kNormals = 1;

static_assert(sizeof(Vec3f) == 3 * sizeof(float), "vertices are uploaded as they lie");

int byteCount(std::size_t vertices) { return static_cast<int>(vertices * sizeof(Vec3f)); }

/// Makes a context current, and on leaving the one that was current before.
class CurrentFor
{
public:
    CurrentFor(QOpenGLContext& context, QSurface& surface)
        : m_context{context},
          m_before{QOpenGLContext::currentContext()},
          m_surfaceBefore{m_before != nullptr ? m_before->surface() : nullptr},
          m_current{context.makeCurrent(&surface)}
    {
    }
    ~CurrentFor()
    {
        if (m_before != nullptr)
            m_before->makeCurrent(m_surfaceBefore);
        else
            m_context.doneCurrent();
    }
    Q_DISABLE_COPY_MOVE(CurrentFor)

    explicit operator bool() const { return m_current; }

private:
    QOpenGLContext& m_context;
    QOpenGLContext* m_before;
    QSurface* m_surfaceBefore;
    bool m_current;
};

QSurfaceFormat coreProfile()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

} // namespace

/// Everything on the side of OpenGL; lives at one address, as its Qt objects must.
class DrawnVertices::Card
{
public:
    Card() = default;
    ~Card();
    Q_DISABLE_COPY_MOVE(Card)

    Result<void> start(const TriangleMesh& mesh, ChestRegion region, const OrganShader& shader);
    Result<Vertices> draw(const ChestField& field, const ChestMotion& motion,
                          const FollowingThroat& throat, const BladeField& blade,
                          const AirwayField& airway);

private:
    struct Objects {
        QOpenGLShaderProgram program;
        QOpenGLVertexArrayObject vertexArray;
        std::vector<QOpenGLBuffer> inputs;
        std::array<QOpenGLBuffer, kCaptured.size()> outputs;
    };

    Result<void> link();
    void upload(const char* attribute, const std::vector<Vec3f>& values);
    bool read(std::size_t captured, std::vector<Vec3f>& values);
    void runShader(const ChestField& field, const ChestMotion& motion,
                   const FollowingThroat& throat, const BladeField& blade,
                   const AirwayField& airway);

    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
    std::unique_ptr<Objects> m_objects; // made and destroyed while m_context is current
    std::size_t m_vertexCount = 0;
    ChestRegion m_region = ChestRegion::Still;
    OrganShader m_shader;
};

DrawnVertices::Card::~Card()
{
    if (m_objects == nullptr)
        return;
    const CurrentFor current{m_context, m_surface};
    m_objects.reset();
}

Result<void> DrawnVertices::Card::start(const TriangleMesh& mesh, ChestRegion region,
                                        const OrganShader& shader)
{
    m_region = region;
    m_shader = shader;
    m_surface.setFormat(coreProfile());
    m_surface.create();
    m_context.setFormat(coreProfile());
    if (!m_context.create())
        return fail(Errc::NoGraphics, "no OpenGL context could be made");
    const CurrentFor current{m_context, m_surface};
    if (!current || m_context.isOpenGLES() || m_context.format().version() < std::pair{3, 3})
        return fail(Errc::NoGraphics, "OpenGL 3.3 is not there");
    m_objects = std::make_unique<Objects>();
    if (const Result<void> linked = link(); !linked)
        return linked;

    m_vertexCount = mesh.positions.size();
    m_objects->vertexArray.create();
    const QOpenGLVertexArrayObject::Binder bound{&m_objects->vertexArray};
    upload("vertexPosition", mesh.positions);
    upload("vertexNormal", mesh.normals);
    for (QOpenGLBuffer& output : m_objects->outputs) {
        output.create();
        output.bind();
        output.allocate(byteCount(m_vertexCount));
    }
    return {};
}

Result<void> DrawnVertices::Card::link()
{
    QOpenGLShaderProgram& program = m_objects->program;
    if (program.addShaderFromSourceCode(QOpenGLShader::Vertex, organVertexShader(m_shader))) {
        m_context.extraFunctions()->glTransformFeedbackVaryings(
            program.programId(), kCaptured.size(), kCaptured.data(), GL_SEPARATE_ATTRIBS);
        if (program.link())
            return {};
    }
    return fail(Errc::NoGraphics, program.log().toStdString());
}

void DrawnVertices::Card::upload(const char* attribute, const std::vector<Vec3f>& values)
{
    CARINA_EXPECTS(values.size() == m_vertexCount);
    QOpenGLBuffer& buffer = m_objects->inputs.emplace_back(QOpenGLBuffer::VertexBuffer);
    buffer.create();
    buffer.bind();
    buffer.allocate(values.data(), byteCount(values.size()));
    m_objects->program.enableAttributeArray(attribute);
    m_objects->program.setAttributeBuffer(attribute, GL_FLOAT, 0, 3);
}

void DrawnVertices::Card::runShader(const ChestField& field, const ChestMotion& motion,
                                    const FollowingThroat& throat, const BladeField& blade,
                                    const AirwayField& airway)
{
    QOpenGLShaderProgram& program = m_objects->program;
    QOpenGLExtraFunctions& gl = *m_context.extraFunctions();
    const QOpenGLVertexArrayObject::Binder bound{&m_objects->vertexArray};
    program.bind();
    program.setUniformValue("modelMatrix", QMatrix4x4{});
    program.setUniformValue("mvp", QMatrix4x4{});
    program.setUniformValue("modelNormalMatrix", QMatrix3x3{});
    program.setUniformValue("chest", chestUniform(field));
    const auto region = static_cast<int>(m_region);
    const QString inRegion = QStringLiteral("regions[%1].motion").arg(region);
    program.setUniformValue(
        program.uniformLocation(m_shader.hasManyRegions ? inRegion : QStringLiteral("motion")),
        motionUniform(motion));
    program.setUniformValue("throat", throatUniform(throat.field));
    program.setUniformValue("jaw", jawUniform(throat.X_AJ));
    program.setUniformValue("blade", bladeUniform(blade));
    program.setUniformValue("tilt", tiltUniform(blade));
    for (const NamedUniform& uniform : neckUniforms(throat.neck))
        program.setUniformValue(uniform.name, uniform.value);
    for (const NamedUniform& uniform : airwayUniforms(airway))
        program.setUniformValue(uniform.name, uniform.value);
    program.setAttributeValue("vertexPart", 0.0F, static_cast<float>(region), 0.0F);
    for (std::size_t k = 0; k < kCaptured.size(); ++k) {
        gl.glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLuint>(k),
                            m_objects->outputs[k].bufferId());
    }
    gl.glEnable(GL_RASTERIZER_DISCARD);
    gl.glBeginTransformFeedback(GL_POINTS);
    gl.glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(m_vertexCount));
    gl.glEndTransformFeedback();
    gl.glDisable(GL_RASTERIZER_DISCARD);
    for (std::size_t k = 0; k < kCaptured.size(); ++k)
        gl.glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLuint>(k), 0);
    program.release();
}

bool DrawnVertices::Card::read(std::size_t captured, std::vector<Vec3f>& values)
{
    values.resize(m_vertexCount);
    QOpenGLBuffer& output = m_objects->outputs[captured];
    output.bind();
    const bool wasRead = output.read(0, values.data(), byteCount(m_vertexCount));
    output.release();
    return wasRead;
}

Result<DrawnVertices::Vertices> DrawnVertices::Card::draw(const ChestField& field,
                                                          const ChestMotion& motion,
                                                          const FollowingThroat& throat,
                                                          const BladeField& blade,
                                                          const AirwayField& airway)
{
    const CurrentFor current{m_context, m_surface};
    if (!current)
        return fail(Errc::NoGraphics, "the OpenGL context was lost");
    runShader(field, motion, throat, blade, airway);
    Vertices drawn;
    const bool wasRead = read(kPositions, drawn.positions) && read(kNormals, drawn.normals);
    if (!wasRead || m_context.functions()->glGetError() != GL_NO_ERROR)
        return fail(Errc::NoGraphics, "what was drawn could not be read back");
    return drawn;
}

DrawnVertices::DrawnVertices(std::unique_ptr<Card> card) : m_card{std::move(card)} {}
DrawnVertices::DrawnVertices(DrawnVertices&&) noexcept = default;
DrawnVertices& DrawnVertices::operator=(DrawnVertices&&) noexcept = default;
DrawnVertices::~DrawnVertices() = default;

Result<DrawnVertices> DrawnVertices::of(const TriangleMesh& mesh, ChestRegion region,
                                        const OrganShader& shader)
{
    CARINA_EXPECTS(!mesh.positions.empty());
    auto card = std::make_unique<Card>();
    if (const Result<void> started = card->start(mesh, region, shader); !started)
        return tl::unexpected(started.error());
    return DrawnVertices{std::move(card)};
}

Result<DrawnVertices::Vertices>
DrawnVertices::at(const ChestField& field, const ChestMotion& motion, const FollowingThroat& throat,
                  const BladeField& blade, const AirwayField& airway)
{
    return m_card->draw(field, motion, throat, blade, airway);
}

} // namespace carina
