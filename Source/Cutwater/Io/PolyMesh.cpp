#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/PolyMesh.hpp>
#include <Cutwater/Text/Output.hpp>

#include <set>
#include <string_view>
#include <system_error>

// OpenFOAM's polyMesh, as its user guide (section 4.1) describes it.

namespace cutwater {

namespace {

/// A file of the mesh: a header, then a list, as text or as numbers in memory.
class FoamFile {
 public:
  FoamFile(const std::filesystem::path& folder, const char* name, const char* kind, bool isBinary,
           const std::string& note = {})
      : file_(folder / name), out_(file_), isBinary_(isBinary) {
    out_ << "FoamFile\n{\n    version     2.0;\n    format      " << (isBinary ? "binary" : "ascii")
         << ";\n    class       " << kind << ";\n    arch        \"LSB;label=32;scalar=64\";\n";
    if (!note.empty()) out_ << "    note        \"" << note << "\";\n";
    out_ << "    location    \"constant/polyMesh\";\n    object      " << name << ";\n}\n\n";
  }

  [[nodiscard]] text::Output& out() { return out_; }
  [[nodiscard]] bool isBinary() const { return isBinary_; }

  /// Writes `count` items; `write(n)` writes one of them.
  template <typename Write>
  void list(std::size_t count, const Write& write) {
    out_ << std::uint64_t{count} << "\n(";
    if (!isBinary_) out_ << '\n';
    for (std::size_t n = 0; n < count; ++n) {
      write(n);
      if (!isBinary_) out_ << '\n';
    }
    out_ << ")\n";
  }
  void label(std::uint64_t value) {
    if (isBinary_) {
      out_.binary(static_cast<std::int32_t>(value));
    } else {
      out_ << value;
    }
  }
  void labels(std::span<const std::uint32_t> values) {
    list(values.size(), [&](std::size_t n) { label(values[n]); });
  }
  void commit() {
    out_.flush();
    file_.commit();
  }

 private:
  OutputFile file_;
  text::Output out_;
  bool isBinary_;
};

void writePoints(FoamFile file, const std::vector<Vec3<double>>& points) {
  file.list(points.size(), [&](std::size_t n) {
    const auto& p = points[n];
    if (file.isBinary()) {
      for (int axis = 0; axis < 3; ++axis) file.out().binary(p[axis]);
    } else {
      file.out() << '(' << p << ')';
    }
  });
  file.commit();
}

void writeFaces(FoamFile file, const FluidMesh::Faces& faces) {
  if (file.isBinary()) {
    file.list(faces.first.size(), [&](std::size_t n) { file.label(faces.first[n]); });
    file.labels(faces.corners);
  } else {
    file.list(faces.count(), [&](std::size_t n) {
      const auto corners = faces.of(n);
      file.label(corners.size());
      for (std::size_t k = 0; k < corners.size(); ++k) {
        file.out() << (k == 0 ? '(' : ' ');
        file.label(corners[k]);
      }
      file.out() << ')';
    });
  }
  file.commit();
}

void writeLabels(FoamFile file, std::span<const std::uint32_t> values) {
  file.labels(values);
  file.commit();
}

/// A word of OpenFOAM's that none has yet.
std::string wordFor(const std::string& name, std::set<std::string>& taken) {
  constexpr std::string_view kForbidden = "\"'/;{}()[]$#\\";
  std::string word = name;
  for (auto& c : word) {
    const auto code = static_cast<unsigned char>(c);
    if (code <= ' ' || code == 0x7f || kForbidden.find(c) != std::string_view::npos) c = '_';
  }
  if (word.empty()) word = "wall";
  auto unique = word;
  for (int n = 1; !taken.insert(unique).second; ++n) unique = word + '_' + std::to_string(n);
  return unique;
}

void writeBoundary(FoamFile file, const std::vector<FluidMesh::Patch>& patches) {
  std::set<std::string> taken;
  file.list(patches.size(), [&](std::size_t n) {
    const auto& [name, kind, first, count] = patches[n];
    const bool isWall = kind == FluidMesh::PatchKind::Wall;
    file.out() << "    " << wordFor(name, taken) << "\n    {\n        type            "
               << (isWall ? "wall;\n        inGroups        1(wall)" : "patch")
               << ";\n        nFaces          " << std::uint64_t{count}
               << ";\n        startFace       " << std::uint64_t{first} << ";\n    }";
  });
  file.commit();
}

void writeZones(FoamFile file, const FluidMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> cells(mesh.regions.size());
  for (std::uint32_t n = 0; n < mesh.cells.region.size(); ++n) {
    cells[mesh.cells.region[n]].push_back(n);
  }
  auto& out = file.out();
  out << std::uint64_t{cells.size()} << "\n(\n";
  for (std::size_t n = 0; n < cells.size(); ++n) {
    out << "region" << std::uint64_t{n}
        << "\n{\n    type cellZone;\ncellLabels      List<label> \n";
    file.labels(cells[n]);
    out << ";\n}\n";
  }
  out << ")\n";
  file.commit();
}

}  // namespace

void writePolyMesh(const std::filesystem::path& caseFolder, const FluidMesh& mesh,
                   const PolyMeshOptions& options) {
  const auto folder = caseFolder / "constant" / "polyMesh";
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) throw Error(ErrorKind::File, folder.string() + ": " + failure.message());
  for (const auto* zones : {"cellZones", "faceZones", "pointZones"}) {
    std::filesystem::remove(folder / zones, failure);
  }
  const auto& faces = mesh.faces;
  const auto note = "nPoints:" + std::to_string(mesh.points.size()) +
                    "  nCells:" + std::to_string(mesh.cells.leaf.size()) +
                    "  nFaces:" + std::to_string(faces.count()) +
                    "  nInternalFaces:" + std::to_string(faces.neighbour.size());
  const auto kind = options.binary;
  writePoints({folder, "points", "vectorField", kind}, mesh.points);
  writeFaces({folder, "faces", kind ? "faceCompactList" : "faceList", kind}, faces);
  writeLabels({folder, "owner", "labelList", kind, note}, faces.owner);
  writeLabels({folder, "neighbour", "labelList", kind, note}, faces.neighbour);
  writeBoundary({folder, "boundary", "polyBoundaryMesh", false}, mesh.patches);
  if (mesh.regions.size() > 1) writeZones({folder, "cellZones", "regIOobject", kind}, mesh);
}

}  // namespace cutwater
