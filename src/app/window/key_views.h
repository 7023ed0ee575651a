// The active keys beside their blend: a small picture of each, seen by the camera of the blend, with the same node
// outlined in all.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/document/session.h"
#include "app/pictures/node_outline.h"
#include "app/pictures/scene_picture.h"
#include "family/family_fields.h"
#include "family/shared_hierarchy.h"
#include "hierarchy/field.h"
#include "hierarchy/nodes/node_path.h"
#include "hierarchy/union_mesh.h"
#include "render/camera.h"
#include "render/color_map.h"
#include "render/display.h"
#include "render/renderer.h"
#include "ui/gui.h"
#include "ui/widgets/rect.h"

namespace interleaf {

class KeyViews {
  public:
    /// Takes the first active keys of \p session, one per place, and the values that its display shows.
    /// \param places  of the pictures in the window
    /// \param field   the field that the display shows; null for none
    /// \pre an OpenGL context is current
    void follow(const Session& session, std::span<const Rect> places, const FamilyField* field);

    /// The leaf of the key at \p pointer in the picture \p place; none beside it.
    std::optional<NodePath> leaf_at(std::size_t place, glm::vec2 pointer, const Camera& camera) const;

    /// Draws the pictures into the window, behind the panels. Where that takes long, some are drawn in later frames.
    /// \param scale          of a coloring by values that the blend determines
    /// \param window_height  screen coordinates
    /// \return whether all pictures have their final quality; otherwise draw again soon
    bool draw(const Display& display, const ColorScale& scale, const Camera& camera, const Gui& gui,
              float window_height);

    /// Draws the names over the pictures, and the outline of \p node in each, if there is one.
    void draw_marks(const Camera& camera, const std::optional<NodePath>& node, const Gui& gui);

    void reload_shaders();

  private:
    /// What the renderer of a key has besides its surface.
    struct Values {
        Coloring coloring = Coloring::plain;  ///< by values of the key; plain for any other
        std::optional<FieldName> field{};
        bool operator==(const Values&) const = default;
    };
    struct View {
        SharedHierarchy hierarchy;
        std::size_t key = 0;  ///< index in the family
        std::string name{};
        Rect place{};
        UnionMesh mesh{};
        std::size_t number = 0;  ///< of the mesh, and of its values
        std::optional<Values> values{};
        Renderer renderer{};
        ScenePicture picture{};
        NodeOutline outline{};
    };
    void take_key(View& view, const Family& family, const Values& values);
    static void draw_name(const View& view);
    void draw_outline(View& view, const Camera& camera, const NodePath& node, const Gui& gui);

    std::vector<std::unique_ptr<View>> views_;
    std::size_t next_ = 0;    ///< the view that is drawn first in the next frame
    std::size_t number_ = 0;  ///< the last number of a mesh
    std::size_t more_ = 0;    ///< active keys without a picture
};

}  // namespace interleaf
